#pragma once
// A contact or a tie as a linear map of an island's unknowns.

#include <array>
#include <cstddef>

#include "server/physics/mechanics/contact/contact.h"

namespace prosector::coupled {

/// Side of a contact or tie, as a linear map of the island's unknowns. It is a weighted sum of soft nodes, or
/// a point of a rigid body at an arm from its centre of mass. A fixed side has no unknowns.
struct JointSide {
  std::size_t nodes = 0;  // soft: number of nodes
  std::array<Eigen::Index, contact::ContactSide::most_nodes>
      offset{};                                                   // soft: index of each node's first unknown
  std::array<double, contact::ContactSide::most_nodes> weight{};  // soft: weight of each node
  std::size_t member = 0;                                         // soft: index of the island's soft member
  Eigen::Index rigid = -1;  // rigid: index of the first unknown of the body's twist; else −1
  Vec3 arm = Vec3::Zero();  // rigid: m, from the centre of mass
};

/// Linearised contact or tie of an island. It gives the displacement of its side a relative to side b as a
/// linear map of the island's unknowns, and its 3×3 stiffness.
struct Joint {
  JointSide a, b;
  // m: relative position at the tick's start by the linear map, minus kinematic motion in the tick.
  Vec3 at_start;
  Vec3 force = Vec3::Zero();      // N, contacts: force on b at the point of linearisation
  Vec3 foreseen = Vec3::Zero();   // N, contacts: force on b predicted by the last step
  Vec3 exchanged = Vec3::Zero();  // N, contacts: force on b exchanged by the steps so far
  double threshold = 0;           // m, contacts: slip over which friction builds up
  Vec3 held = Vec3::Zero();       // m, contacts: slip at the tick's start
  Mat3 D = Mat3::Zero();          // N/m
};

/// Returns the displacement (m) of a side of a contact or tie, where q has displacements of nodes and twists
/// of rigid bodies. If q has node positions, returns the side's position instead.
inline Vec3 moved_by(const JointSide& side, const VecX& q) {
  Vec3 u = Vec3::Zero();
  for (std::size_t k = 0; k < side.nodes; ++k) u += side.weight[k] * q.segment<3>(side.offset[k]);
  if (side.rigid >= 0) {
    const Vec3 rotation = q.segment<3>(side.rigid + 3);
    u += q.segment<3>(side.rigid) + rotation.cross(side.arm);
  }
  return u;
}

/// Returns the displacement (m, world frame) of the joint's side a relative to its side b since the tick's
/// start, for the island's unknowns q.
inline Vec3 displacement(const Joint& joint, const VecX& q) {
  return moved_by(joint.a, q) - moved_by(joint.b, q) - joint.at_start;
}

/// Adds the force f (N) on a side of a contact or tie to the soft nodes of that side, by their weights.
/// Ignores a rigid side. `out`: generalised forces by unknown.
inline void add_to_nodes(const JointSide& side, const Vec3& f, VecX& out) {
  for (std::size_t k = 0; k < side.nodes; ++k) out.segment<3>(side.offset[k]) += side.weight[k] * f;
}

/// Adds the force f (N) on a side of a contact or tie to the generalised forces `out`. A soft side
/// distributes it to its nodes by their weights; a rigid body gets force and moment.
inline void add_force(const JointSide& side, const Vec3& f, VecX& out) {
  add_to_nodes(side, f, out);
  if (side.rigid >= 0) {
    out.segment<3>(side.rigid) += f;
    out.segment<3>(side.rigid + 3) += side.arm.cross(f);
  }
}

}  // namespace prosector::coupled
