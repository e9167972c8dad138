#pragma once
// Matrix-vector products with the stiffness of an island's joints, packed for the linear solver, which needs
// one per iteration. Sums at a node or body are in joint order for any thread count.

#include <cstdint>
#include <span>
#include <vector>

#include "server/physics/mechanics/coupled/island_layout.h"

namespace prosector {

/// Packed stiffness matrix of an island's joints.
class JointProduct {
 public:
  /// Packs these joints with their stiffnesses, in order. Allocates only for more joints than before.
  void set(const IslandLayout& layout, std::span<const Joint* const> joints);

  /// Adds the joints' stiffness times p to Hp; both have the island's unknowns.
  void multiply(const VecX& p, VecX& Hp) const;
  /// Subtracts from the nodes' part of g the joint forces on nodes due to the bodies' part of z.
  void subtract_from_nodes(const VecX& z, VecX& g) const;
  /// Subtracts from the bodies' part of g the joint forces on bodies due to the nodes' part of p.
  void subtract_from_bodies(const VecX& p, VecX& g) const;

 private:
  static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);

  /// A node in a joint's side, with its weight.
  struct Hanging {
    std::uint32_t at;  // index of its first unknown
    double weight;
  };
  struct Row {
    std::uint32_t a, b, end;       // ranges in hanging_: side a from a to b, side b from b to end
    std::uint32_t body_a, body_b;  // index of the bodies' first unknown, or none
    Vec3 arm_a, arm_b;             // m
    Mat3 D;                        // N/m
  };
  /// The contribution of a row's force to a node. At each node, rows are ascending, and side a is first.
  struct Share {
    std::uint32_t row;
    double weight;  // of the force on a; negative for side b
  };
  struct Moment {
    std::uint32_t row;
    bool is_b;
  };
  /// Nodes or bodies with the ranges of their contributions in a list.
  struct Places {
    std::vector<std::uint32_t> at;     // index of the first unknown, ascending
    std::vector<std::uint32_t> begin;  // start of each range, and the end
  };

  void pack_side(const JointSide& side);
  void list_nodes(const IslandLayout& layout);
  void list_bodies(const IslandLayout& layout);
  template <class F>
  void for_rows(const F& f) const;
  void add_to_nodes(VecX& out) const;
  void add_to_bodies(VecX& out) const;
  Vec3 moved_nodes(std::uint32_t begin, std::uint32_t end, const VecX& p) const;

  std::vector<Row> rows_;
  std::vector<Hanging> hanging_;
  Places nodes_, bodies_;
  std::vector<Share> shares_;    // by node
  std::vector<Moment> moments_;  // by body
  std::vector<std::uint32_t> count_;
  mutable std::vector<Vec3> force_;  // N, by row
};

}  // namespace prosector
