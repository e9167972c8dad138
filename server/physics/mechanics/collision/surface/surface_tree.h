#pragma once
// Bounding volume hierarchy of a surface's triangles.

#include <array>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "common/assert.h"
#include "server/physics/mechanics/collision/primitives/aabb.h"

namespace prosector::collision {

/// Bounding volume hierarchy of a surface's triangles: a balanced tree of axis-aligned boxes. It is built
/// once: by splitting at the median centroid along the longest side, or by halving a given order of the
/// triangles. When the surface moves, refit() updates the boxes in O(triangles) and keeps the tree structure.
/// Up to rounding, query results do not depend on the tree structure, as ties are broken by index; the cost
/// of queries does.
class SurfaceTree {
 public:
  using Corners = std::array<std::uint32_t, 3>;
  static constexpr std::uint32_t leaf_triangles = 4;
  static constexpr std::size_t deepest = 40;  // levels: enough for more than 2³² triangles

  /// Node of a surface's bounding volume tree: a box around a range of triangles. Nodes are stored in
  /// preorder, so the left child directly follows its parent.
  struct Node {
    Aabb box;
    std::uint32_t begin = 0, end = 0;  // range of the node's triangles in order()
    std::uint32_t right = 0;           // index of the right child; 0: a leaf
    bool leaf() const { return right == 0; }
  };

  SurfaceTree(std::span<const Corners> triangles, std::span<const Vec3> positions);
  /// Builds the tree by halving `order`, a list of all triangle indices in which neighbours are close to each
  /// other (space_order.h). After triangles were added or removed, the tree is built in this way from the
  /// updated order.
  SurfaceTree(std::span<const Corners> triangles, std::span<const Vec3> positions,
              std::span<const std::uint32_t> order);
  void refit(std::span<const Corners> triangles, std::span<const Vec3> positions);

  std::span<const Node> nodes() const { return nodes_; }
  std::span<const std::uint32_t> order() const { return order_; }
  bool empty() const { return nodes_.empty(); }
  const Aabb& box() const { return nodes_.front().box; }

  /// Visits the tree from left to right and calls leaf(node) for each leaf. Skips each node, with its
  /// descendants, for whose box enter(box) returns false.
  template <class Enter, class Leaf>
  void visit(const Enter& enter, const Leaf& leaf) const;
  /// Searches the tree for a minimum, the child with the lower bound first, and calls leaf(node) for each
  /// leaf reached. `bound(box)`: a lower bound of the values of all triangles in the box. `limit()`: the best
  /// value so far; nodes whose bound exceeds it are skipped.
  template <class Bound, class Limit, class Leaf>
  void descend(const Bound& bound, const Limit& limit, const Leaf& leaf) const;

 private:
  template <class F>
  std::uint32_t build(std::uint32_t begin, std::uint32_t end, const F& halve);

  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

template <class Enter, class Leaf>
void SurfaceTree::visit(const Enter& enter, const Leaf& leaf) const {
  if (nodes_.empty()) return;
  std::array<std::uint32_t, deepest> stack;
  std::size_t height = 0;
  stack[height++] = 0;
  while (height > 0) {
    const std::uint32_t i = stack[--height];
    const Node& node = nodes_[i];
    if (!enter(node.box)) continue;
    if (node.leaf()) {
      leaf(node);
      continue;
    }
    PROSECTOR_ASSERT(height + 2 <= stack.size());
    stack[height++] = node.right;
    stack[height++] = i + 1;
  }
}

template <class Bound, class Limit, class Leaf>
void SurfaceTree::descend(const Bound& bound, const Limit& limit, const Leaf& leaf) const {
  if (nodes_.empty()) return;
  struct Entry {
    std::uint32_t node;
    double bound;
  };
  std::array<Entry, deepest> stack;
  std::size_t height = 0;
  stack[height++] = {0, bound(nodes_[0].box)};
  while (height > 0) {
    const Entry at = stack[--height];
    if (!(at.bound <= limit())) continue;
    const Node& node = nodes_[at.node];
    if (node.leaf()) {
      leaf(node);
      continue;
    }
    PROSECTOR_ASSERT(height + 2 <= stack.size());
    Entry left{at.node + 1, bound(nodes_[at.node + 1].box)}, right{node.right, bound(nodes_[node.right].box)};
    if (right.bound < left.bound) std::swap(left, right);
    stack[height++] = right;
    stack[height++] = left;
  }
}

}  // namespace prosector::collision
