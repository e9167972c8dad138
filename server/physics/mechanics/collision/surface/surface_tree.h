#pragma once
// Bounding volume hierarchy of a surface's triangles.

#include <array>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "common/assert.h"
#include "server/physics/mechanics/collision/primitives/aabb.h"

namespace prosector {

/// Balanced tree of axis-aligned boxes. It is built once: by splitting at the median centroid along the
/// longest side, or from runs of a given order. When the surface moves, refit() updates the boxes in
/// O(triangles) and keeps the tree structure. Up to rounding, query results do not depend on the tree: ties
/// are broken by index. Query costs do.
class SurfaceTree {
 public:
  using Corners = std::array<std::uint32_t, 3>;
  static constexpr std::uint32_t leaf_triangles = 4;
  static constexpr std::size_t deepest = 40;  // levels: enough for more than 2³² triangles

  /// Nodes are in preorder: the left child follows its parent.
  struct Node {
    Aabb box;
    std::uint32_t begin = 0, end = 0;  // range of the node's triangles in order()
    std::uint32_t right = 0;           // index of the right child; 0: a leaf
    bool leaf() const { return right == 0; }
  };

  SurfaceTree(std::span<const Corners> triangles, std::span<const Vec3> positions);
  /// Builds the tree from runs of `order`, which keeps neighbours together (space_order.h). When triangles
  /// are added or removed, the tree is rebuilt from the updated order.
  SurfaceTree(std::span<const Corners> triangles, std::span<const Vec3> positions,
              std::span<const std::uint32_t> order);
  void refit(std::span<const Corners> triangles, std::span<const Vec3> positions);

  std::span<const Node> nodes() const { return nodes_; }
  std::span<const std::uint32_t> order() const { return order_; }
  bool empty() const { return nodes_.empty(); }
  const Aabb& box() const { return nodes_.front().box; }

  /// Calls leaf(node), from left to right, for all leaves whose own and ancestors' boxes pass enter(box).
  template <class Enter, class Leaf>
  void visit(const Enter& enter, const Leaf& leaf) const;
  /// Traverses the tree, best child first. `bound(box)`: a lower bound of the result of leaf(node). Skips
  /// nodes whose bound exceeds `limit()`.
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

}  // namespace prosector
