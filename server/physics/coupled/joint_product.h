#pragma once
// Products with the stiffness of an island's joints, packed for the linear solver, which asks for one each
// iteration. The sums at a node or body are those of one joint after the other, whoever does them.

#include <cstdint>
#include <span>
#include <vector>

#include "server/physics/coupled/island_layout.h"

namespace prosector {

class JointProduct {
 public:
  /// Packs these joints with their stiffnesses, in their order. Allocates only for more than there ever were.
  void set(const IslandLayout& layout, std::span<const Joint* const> joints);

  /// Adds the joints' stiffness times p to Hp, both of the island's unknowns.
  void multiply(const VecX& p, VecX& Hp) const;
  /// Subtracts from the nodes' part of g what the joints do to nodes when bodies move by z's part of theirs.
  void subtract_from_nodes(const VecX& z, VecX& g) const;
  /// Subtracts from the bodies' part of g what the joints do to bodies when nodes move by p's part of theirs.
  void subtract_from_bodies(const VecX& p, VecX& g) const;

 private:
  static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);

  /// A node that a joint's side hangs on.
  struct Hanging {
    std::uint32_t at;  // where its unknowns begin
    double weight;
  };
  struct Row {
    std::uint32_t a, b, end;       // where hangings of side a begin, those of side b, and they end
    std::uint32_t body_a, body_b;  // where the bodies' unknowns begin, or none
    Vec3 arm_a, arm_b;             // m
    Mat3 D;                        // N/m
  };
  /// A joint's force where it acts: rows ascending at each place, side a first.
  struct Share {
    std::uint32_t row;
    double weight;  // of the force on a: −1 times for b
  };
  struct Moment {
    std::uint32_t row;
    bool is_b;
  };
  /// What acts at places, as ranges of a list.
  struct Places {
    std::vector<std::uint32_t> at;     // where each's unknowns begin, ascending
    std::vector<std::uint32_t> begin;  // one more than places
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
