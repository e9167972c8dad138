#pragma once
// A contact or a tie as a linear map of an island's unknowns.

#include <array>
#include <cstddef>

#include "server/physics/contact/contact.h"

namespace prosector {

/// A contact's or tie's side, resolved to unknowns. One that is fixed has none.
struct JointSide {
  std::size_t nodes = 0;                                       // soft: how many …
  std::array<Eigen::Index, ContactSide::most_nodes> offset{};  // … where each's unknowns begin …
  std::array<double, ContactSide::most_nodes> weight{};        // … and their weights
  std::size_t member = 0;                                      // soft: which of the island's soft members
  Eigen::Index rigid = -1;  // rigid: where its body's twist begins; else −1
  Vec3 arm = Vec3::Zero();  // rigid: m, from the centre of mass
};

/// The displacement of side a relative to side b, as a linear map of the unknowns, and its 3×3 stiffness.
struct Joint {
  JointSide a, b;
  Vec3 at_start;  // m: the linear map of the positions at the tick's start, and what is driven meanwhile
  Vec3 force = Vec3::Zero();      // N, contacts: where it was linearised, on b …
  Vec3 foreseen = Vec3::Zero();   // … what the last step took it for …
  Vec3 exchanged = Vec3::Zero();  // … and what the steps taken made of it
  double threshold = 0;           // m, contacts: slip over which friction builds up
  Vec3 held = Vec3::Zero();       // m, contacts: slip at the tick's start
  Mat3 D = Mat3::Zero();          // N/m
};

/// Returns what unknowns q move the side by, or its position by the nodes' positions, m.
inline Vec3 moved_by(const JointSide& side, const VecX& q) {
  Vec3 u = Vec3::Zero();
  for (std::size_t k = 0; k < side.nodes; ++k) u += side.weight[k] * q.segment<3>(side.offset[k]);
  if (side.rigid >= 0) {
    const Vec3 rotation = q.segment<3>(side.rigid + 3);
    u += q.segment<3>(side.rigid) + rotation.cross(side.arm);
  }
  return u;
}

/// Returns the displacement of side a relative to side b since the tick's start, m.
inline Vec3 displacement(const Joint& joint, const VecX& q) {
  return moved_by(joint.a, q) - moved_by(joint.b, q) - joint.at_start;
}

/// Adds force f (N) on the side to what acts on its soft nodes alone.
inline void add_to_nodes(const JointSide& side, const Vec3& f, VecX& out) {
  for (std::size_t k = 0; k < side.nodes; ++k) out.segment<3>(side.offset[k]) += side.weight[k] * f;
}

/// Adds force f (N) on the side to what acts on the unknowns.
inline void add_force(const JointSide& side, const Vec3& f, VecX& out) {
  add_to_nodes(side, f, out);
  if (side.rigid >= 0) {
    out.segment<3>(side.rigid) += f;
    out.segment<3>(side.rigid + 3) += side.arm.cross(f);
  }
}

}  // namespace prosector
