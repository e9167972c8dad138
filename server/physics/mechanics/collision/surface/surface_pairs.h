#pragma once
// Simultaneous traversal of two surfaces' trees.

#include <array>

#include "common/assert.h"
#include "server/physics/mechanics/collision/surface/surface_tree.h"

namespace prosector::collision {

/// Traverses the bounding volume trees of two surfaces simultaneously. Calls leaf(node of a, node of b) for
/// pairs of leaves whose boxes' squared distance is at most `limit()`, m². The nearer boxes are visited
/// first, and `limit()` may decrease during the traversal. `rotation` and `shift` transform the boxes of b
/// into the frame of a.
template <class Limit, class Leaf>
void descend_pairs(const SurfaceTree& a, const SurfaceTree& b, const Mat3& rotation, const Vec3& shift,
                   const Limit& limit, const Leaf& leaf) {
  if (a.empty() || b.empty()) return;
  struct Entry {
    std::uint32_t i, j;
    double squared_distance;
    Aabb box_b;
  };
  const auto nodes_a = a.nodes(), nodes_b = b.nodes();
  std::array<Entry, 2 * SurfaceTree::deepest> stack;
  std::size_t height = 0;
  const auto moved = [&](std::uint32_t j) { return transformed(nodes_b[j].box, rotation, shift); };
  const auto entry = [&](std::uint32_t i, std::uint32_t j, const Aabb& box_b) {
    return Entry{i, j, nodes_a[i].box.squared_distance(box_b), box_b};
  };
  stack[height++] = entry(0, 0, moved(0));
  while (height > 0) {
    const Entry at = stack[--height];
    if (!(at.squared_distance <= limit())) continue;
    const SurfaceTree::Node &p = nodes_a[at.i], &q = nodes_b[at.j];
    if (p.leaf() && q.leaf()) {
      leaf(p, q);
      continue;
    }
    PROSECTOR_ASSERT(height + 2 <= stack.size());
    const bool split_a = q.leaf() || (!p.leaf() && p.box.half().squaredNorm() >= q.box.half().squaredNorm());
    Entry near = split_a ? entry(at.i + 1, at.j, at.box_b) : entry(at.i, at.j + 1, moved(at.j + 1));
    Entry far = split_a ? entry(p.right, at.j, at.box_b) : entry(at.i, q.right, moved(q.right));
    if (far.squared_distance < near.squared_distance) std::swap(near, far);
    stack[height++] = far;
    stack[height++] = near;
  }
}

}  // namespace prosector::collision
