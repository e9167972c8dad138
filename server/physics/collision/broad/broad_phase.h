#pragma once
// The second stage: which objects' boxes meet.

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "server/physics/collision/broad/collision_mask.h"
#include "server/physics/collision/broad/dynamic_tree.h"

namespace prosector {

/// Two trees: what moves is looked up in both, what doesn't in none. An object that begins or ceases to move
/// changes tree. The pairs are a function of the boxes alone, not of how the trees came to be.
class BroadPhase {
 public:
  using Id = std::uint32_t;
  using Pair = std::pair<Id, Id>;  // first < second

  /// Takes the margin, m: what an object may move before its place in the tree changes.
  explicit BroadPhase(double margin) : still_(margin), moving_(margin) {}

  /// Ids are the caller's, small and dense. The box must be finite.
  void add(Id id, const Aabb& box, const CollisionMask& mask, bool moves);
  void remove(Id id);
  void update(Id id, const Aabb& box);
  void set_moves(Id id, bool moves);
  bool has(Id id) const { return id < entries_.size() && entries_[id].used; }

  /// Finds the pairs whose boxes meet, whose masks allow it, and of which one moves at least; ascending.
  const std::vector<Pair>& find_pairs();
  /// Ids whose boxes meet this one, ascending.
  std::vector<Id> query(const Aabb& box) const;

  std::size_t still() const { return still_.size(); }
  std::size_t moving() const { return moving_.size(); }
  std::size_t bytes() const;

 private:
  struct Entry {
    Aabb box;
    CollisionMask mask;
    DynamicTree::Leaf leaf = DynamicTree::nothing;
    bool moves = false, used = false;
  };
  DynamicTree& tree(const Entry& entry) { return entry.moves ? moving_ : still_; }

  DynamicTree still_, moving_;
  std::vector<Entry> entries_;
  std::vector<Pair> pairs_;
};

}  // namespace prosector
