#pragma once
// Broad phase, the second collision stage: finds pairs of objects whose bounding boxes overlap.

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "server/physics/mechanics/collision/broad/collision_mask.h"
#include "server/physics/mechanics/collision/broad/dynamic_tree.h"

namespace prosector::collision {

/// Broad phase of collision detection: finds pairs of objects whose bounding boxes overlap. Moving and static
/// objects have separate trees. Moving objects are tested against both trees, static objects are not tested
/// against each other. An object that starts or stops moving changes tree. The pairs depend only on the
/// boxes, not on the history of the trees.
class BroadPhase {
 public:
  using Id = std::uint32_t;
  using Pair = std::pair<Id, Id>;  // first < second

  /// Creates an empty broad phase. `margin`: distance, m, by which an object may move before its leaf in the
  /// tree is reinserted.
  explicit BroadPhase(double margin) : still_(margin), moving_(margin) {}

  /// Adds an object with its bounding box and collision mask; `moves`: whether it is moving rather than
  /// static. The caller chooses unused ids, which should be small and without gaps, as they index an array.
  /// The box must be finite.
  void add(Id id, const Aabb& box, const CollisionMask& mask, bool moves);
  void remove(Id id);
  void update(Id id, const Aabb& box);
  void set_moves(Id id, bool moves);
  bool has(Id id) const { return id < entries_.size() && entries_[id].used; }

  /// Returns the pairs of objects whose boxes overlap, whose masks allow contact, and of which at least one
  /// is moving. Pairs are sorted by ids, the lower id first in each. The reference is valid until the next
  /// call.
  const std::vector<Pair>& find_pairs();
  /// Returns the ids of all objects, moving and static, whose bounding boxes overlap `box`, ascending.
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

}  // namespace prosector::collision
