#include "server/physics/mechanics/collision/broad/broad_phase.h"

#include <algorithm>

#include "common/assert.h"

namespace prosector::collision {

void BroadPhase::add(Id id, const Aabb& box, const CollisionMask& mask, bool moves) {
  PROSECTOR_ASSERT(!has(id));
  if (id >= entries_.size()) entries_.resize(id + 1);
  Entry& entry = entries_[id];
  entry = {box, mask, DynamicTree::nothing, moves, true};
  entry.leaf = tree(entry).insert(box, id);
}

void BroadPhase::remove(Id id) {
  PROSECTOR_ASSERT(has(id));
  Entry& entry = entries_[id];
  tree(entry).remove(entry.leaf);
  entry = {};
}

void BroadPhase::update(Id id, const Aabb& box) {
  PROSECTOR_ASSERT(has(id));
  Entry& entry = entries_[id];
  entry.box = box;
  tree(entry).move(entry.leaf, box);
}

void BroadPhase::set_moves(Id id, bool moves) {
  PROSECTOR_ASSERT(has(id));
  Entry& entry = entries_[id];
  if (entry.moves == moves) return;
  tree(entry).remove(entry.leaf);
  entry.moves = moves;
  entry.leaf = tree(entry).insert(entry.box, id);
}

const std::vector<BroadPhase::Pair>& BroadPhase::find_pairs() {
  pairs_.clear();
  const auto offer = [&](Id i, Id j) {
    const Entry &a = entries_[i], &b = entries_[j];
    if (may_touch(a.mask, b.mask) && a.box.overlaps(b.box))
      pairs_.emplace_back(std::min(i, j), std::max(i, j));
  };
  moving_.pairs_within(offer);
  moving_.pairs_with(still_, offer);
  std::sort(pairs_.begin(), pairs_.end());
  return pairs_;
}

std::vector<BroadPhase::Id> BroadPhase::query(const Aabb& box) const {
  std::vector<Id> out;
  const auto offer = [&](Id id) {
    if (entries_[id].box.overlaps(box)) out.push_back(id);
  };
  still_.query(box, offer);
  moving_.query(box, offer);
  std::sort(out.begin(), out.end());
  return out;
}

std::size_t BroadPhase::bytes() const {
  return still_.bytes() + moving_.bytes() + entries_.capacity() * sizeof(Entry) +
         pairs_.capacity() * sizeof(Pair);
}

}  // namespace prosector::collision
