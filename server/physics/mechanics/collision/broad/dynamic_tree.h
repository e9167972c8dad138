#pragma once
// Dynamic bounding volume tree: boxes can be inserted, removed and moved.

#include <array>
#include <cstdint>
#include <vector>

#include "server/physics/mechanics/collision/primitives/aabb.h"

namespace prosector::collision {

/// Bounding volume tree of enlarged (fat) boxes, so that small movements do not change the tree. A leaf is
/// inserted next to the node whose choice increases the total surface area of the tree's boxes least
/// (Goldsmith and Salmon 1987). Rotations reduce the surface area of the inner boxes (Catto 2019, "Dynamic
/// bounding volume hierarchies"). Nodes are stored in arrays and linked by indices: the same calls build the
/// same tree.
///
/// Bullet's btDbvt is not used: it is single precision, links nodes by pointers, and returns pairs in an
/// order that depends on its history.
class DynamicTree {
 public:
  using Leaf = std::uint32_t;
  static constexpr std::uint32_t nothing = ~0u;

  /// Creates an empty tree. `margin`: distance, m, by which each leaf's box is enlarged on each side.
  explicit DynamicTree(double margin) : margin_(margin) {}

  Leaf insert(const Aabb& box, std::uint32_t user);
  void remove(Leaf leaf);
  /// Updates the box of a leaf. Returns whether the leaf was reinserted, because the box left its enlarged
  /// (fat) box or that had become too large.
  bool move(Leaf leaf, const Aabb& box);

  std::size_t size() const { return leaves_; }
  int height() const { return root_ == nothing ? 0 : nodes_[root_].height; }
  std::uint32_t user(Leaf leaf) const { return nodes_[leaf].user; }
  std::size_t bytes() const { return nodes_.capacity() * sizeof(Node); }

  /// Calls f(user) for each leaf whose enlarged (fat) box overlaps `box`. `user` is the number given at the
  /// leaf's insertion.
  template <class F>
  void query(const Aabb& box, const F& f) const;
  /// Calls f(user, user) once for each pair of leaves of this tree whose enlarged (fat) boxes overlap. `user`
  /// is the number given at a leaf's insertion.
  template <class F>
  void pairs_within(const F& f) const;
  /// Calls f(user of this, user of other) once for each pair of a leaf of this tree and a leaf of `other`
  /// whose enlarged (fat) boxes overlap. `user` is the number given at a leaf's insertion.
  template <class F>
  void pairs_with(const DynamicTree& other, const F& f) const;

 private:
  struct Node {
    Aabb box;
    std::uint32_t parent = nothing;  // parent node; in a free node: the next free node
    std::uint32_t left = nothing, right = nothing;
    std::uint32_t user = nothing;
    int height = 0;
    bool leaf() const { return left == nothing; }
  };

  std::uint32_t take_node();
  void link(Leaf leaf);
  void unlink(Leaf leaf);
  std::uint32_t best_sibling(const Aabb& box) const;
  void refit_from(std::uint32_t node);
  void refit(std::uint32_t node);
  void rotate(std::uint32_t node);
  template <class F>
  static void pairs(const DynamicTree& a, std::uint32_t i, const DynamicTree& b, std::uint32_t j, const F& f);

  double margin_;
  std::vector<Node> nodes_;
  std::uint32_t root_ = nothing, free_ = nothing;
  std::size_t leaves_ = 0;
};

template <class F>
void DynamicTree::query(const Aabb& box, const F& f) const {
  if (root_ == nothing) return;
  std::vector<std::uint32_t> stack{root_};
  while (!stack.empty()) {
    const Node& node = nodes_[stack.back()];
    stack.pop_back();
    if (!node.box.overlaps(box)) continue;
    if (node.leaf()) {
      f(node.user);
      continue;
    }
    stack.push_back(node.right);
    stack.push_back(node.left);
  }
}

template <class F>
void DynamicTree::pairs(const DynamicTree& a, std::uint32_t i, const DynamicTree& b, std::uint32_t j,
                        const F& f) {
  const Node &p = a.nodes_[i], &q = b.nodes_[j];
  if (!p.box.overlaps(q.box)) return;
  if (p.leaf() && q.leaf()) {
    f(p.user, q.user);
  } else if (q.leaf() || (!p.leaf() && p.height >= q.height)) {
    pairs(a, p.left, b, j, f);
    pairs(a, p.right, b, j, f);
  } else {
    pairs(a, i, b, q.left, f);
    pairs(a, i, b, q.right, f);
  }
}

template <class F>
void DynamicTree::pairs_within(const F& f) const {
  for (const Node& node : nodes_)
    if (!node.leaf()) pairs(*this, node.left, *this, node.right, f);
}

template <class F>
void DynamicTree::pairs_with(const DynamicTree& other, const F& f) const {
  if (root_ != nothing && other.root_ != nothing) pairs(*this, root_, other, other.root_, f);
}

}  // namespace prosector::collision
