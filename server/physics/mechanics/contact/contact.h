#pragma once
// A contact in the coupled solver: two sides, each a point of a soft surface or of a rigid body.

#include <array>
#include <cstdint>
#include <limits>
#include <optional>

#include "common/assert.h"
#include "common/mesh.h"

namespace prosector::contact {

/// One side of a contact: a point that moves with a rigid body, or with the nodes of a soft body.
struct ContactSide {
  static constexpr std::size_t most_nodes = 12;  // a point of a triangle: three surface vertices of 4 nodes
  enum class Kind : std::uint8_t { fixed, soft, rigid } kind = Kind::fixed;
  std::size_t body = 0;   // soft: index of the soft body; rigid: slot in the rigid world
  std::size_t nodes = 0;  // soft: number of nodes
  std::array<std::uint32_t, most_nodes> node{};  // soft: node indices, all different
  std::array<double, most_nodes> weight{};       // soft: weight of each node
  Vec3 arm = Vec3::Zero();    // rigid: m, from the centre of mass to the point, at the tick's start
  Vec3 moved = Vec3::Zero();  // fixed: m, its kinematic motion over the tick

  /// Adds a surface vertex of a soft body to the point: the nodes that carry the vertex (`row`), with their
  /// weights times `share`.
  void add(const SparseMap::Row& row, double share) {
    for (std::size_t k = 0; k < row.node.size(); ++k) {
      if (row.weight[k] == 0) continue;
      std::size_t at = 0;
      while (at < nodes && node[at] != row.node[k]) ++at;
      PROSECTOR_ASSERT(at < most_nodes);
      if (at == nodes) node[nodes++] = row.node[k];
      weight[at] += share * row.weight[k];
    }
  }
};

/// Contact between a point of side a and a point of side b. Its potential is ½·stiffness·min(g, 0)², or the
/// mean of that over g ± spread (EvenSpring). Here g = gap + normal·(u_a − u_b), with u the sides'
/// displacements over the tick. Friction is smoothed Coulomb friction (Li et al. 2020, "Incremental Potential
/// Contact", 5). It acts on the slip: the tangential part of u_a − u_b, measured from the point where
/// friction last stuck (contact_memory.h). The normal is constant over a tick.
struct Contact {
  ContactSide a, b;
  Vec3 point = Vec3::Zero();    // m, world frame, at the tick's start
  Vec3 normal = Vec3::UnitY();  // unit, from b to a
  double gap = 0;               // m, at the tick's start, minus `rest`; < 0 presses
  double rest = 0;              // m, <= 0: gap at which the contact force is zero, see contact_memory.h
  double stiffness = 0;         // N/m
  double spread = 0;            // m: the gap varies by ± this over the area that the point represents
  double friction = 0;
  // 0: an ordinary contact; n > 0: a friction-only point of a finger pad (contact/pad.h). Its normal force is
  // 1/patch_points of that of the contact n positions before it in the island.
  std::uint32_t bearer = 0;
  double rebound = 0;  // m/s: separation speed of rigid sides after they have pressed, see restitution.h
  static constexpr std::uint32_t no_feature = std::numeric_limits<std::uint32_t>::max();
  // Index of the surface feature of a soft side a. It is a surface vertex; or a face point (area_contacts.h);
  // or the count of all those plus the triangle; or both counts plus the BoxCorner of b. For layers: as
  // ElementSurface::feature.
  std::uint32_t feature = no_feature;
  std::uint32_t met = 0;     // for layers: the feature of side b
  Vec3 grip = Vec3::Zero();  // slip at the tick's start, in friction thresholds: length at most 1
  double gripped = 0;        // N: normal force of the contact at that time
  // Results:
  double force = 0;  // N, normal, at the tick's end
  /// Mean force over the tick on side a, friction included, N, world frame: the force that changed the
  /// bodies' momenta.
  Vec3 exchanged = Vec3::Zero();
  Vec3 grip_after = Vec3::Zero();  // as grip, at the tick's end

  /// Sets the results to those of a contact that stays open.
  void clear_results() {
    force = 0;
    exchanged.setZero();
    grip_after.setZero();
  }
};

/// Spring of bounded force between a point of side a and a point of side b. It models a hand's hold, or
/// tissue that resists a blade.
struct Tie {
  ContactSide a, b;
  Vec3 offset = Vec3::Zero();  // m: a − b − rest, at the tick's start
  double stiffness = 0;        // N/m
  double max_force = 0;        // N
  // Result:
  Vec3 force = Vec3::Zero();  // N, on a, at the tick's end
};

}  // namespace prosector::contact
