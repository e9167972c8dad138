#pragma once
// Matrix-vector products with the stiffness of an island's joints, packed for the linear solver, which needs
// one per iteration. Sums at a node or body are in joint order for any thread count.

#include <cstdint>
#include <span>
#include <vector>

#include "server/physics/mechanics/coupled/island_layout.h"

namespace prosector::coupled {

/// Stiffness matrix of an island's contacts and ties, packed for fast products with vectors in the linear
/// solver's iterations.
class JointProduct {
 public:
  /// Packs the contacts and ties `joints`, in this order, with their 3×3 stiffnesses. Allocates memory only
  /// if there are more joints than before.
  void set(const IslandLayout& layout, std::span<const Joint* const> joints);

  /// Adds the product of the stiffness matrix of contacts and ties with p to Hp. Both vectors have all
  /// unknowns of the island.
  void multiply(const VecX& p, VecX& Hp) const;
  /// Subtracts A_sr·z_r from the soft nodes' part of g. A_sr is the block of the joints' stiffness matrix
  /// with rows of soft nodes and columns of rigid bodies, and z_r is the rigid bodies' part of z.
  void subtract_from_nodes(const VecX& z, VecX& g) const;
  /// Subtracts A_rs·p_s from the rigid bodies' part of g. A_rs is the block of the joints' stiffness matrix
  /// with rows of rigid bodies and columns of soft nodes, and p_s is the soft nodes' part of p.
  void subtract_from_bodies(const VecX& p, VecX& g) const;

 private:
  static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);

  /// Soft node on one side of a contact or tie, as the index of its first unknown, with its weight.
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
  /// Contribution of one contact's or tie's force to one soft node: the index of the contact or tie, and the
  /// node's weight. At each node they are in ascending order, with side a before side b.
  struct Share {
    std::uint32_t row;
    double weight;  // of the force on a; negative for side b
  };
  struct Moment {
    std::uint32_t row;
    bool is_b;
  };
  /// List of soft nodes or rigid bodies. For each it has the index of its first unknown, and the range of its
  /// contributions in another list.
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

}  // namespace prosector::coupled
