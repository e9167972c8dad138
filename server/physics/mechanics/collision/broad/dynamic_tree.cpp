#include "server/physics/mechanics/collision/broad/dynamic_tree.h"

#include <limits>
#include <utility>

#include "common/assert.h"

namespace prosector::collision {
namespace {

Aabb around(const Aabb& a, const Aabb& b) {
  Aabb out = a;
  out.add(b);
  return out;
}

}  // namespace

std::uint32_t DynamicTree::take_node() {
  if (free_ == nothing) {
    nodes_.emplace_back();
    return static_cast<std::uint32_t>(nodes_.size() - 1);
  }
  const std::uint32_t node = free_;
  free_ = nodes_[node].parent;
  nodes_[node] = {};
  return node;
}

DynamicTree::Leaf DynamicTree::insert(const Aabb& box, std::uint32_t user) {
  PROSECTOR_ASSERT(margin_ >= 0 && user != nothing);
  const Leaf leaf = take_node();
  nodes_[leaf].box = box.grown(margin_);
  nodes_[leaf].user = user;
  link(leaf);
  ++leaves_;
  return leaf;
}

void DynamicTree::remove(Leaf leaf) {
  PROSECTOR_ASSERT(leaf < nodes_.size() && nodes_[leaf].leaf() && nodes_[leaf].user != nothing &&
                   leaves_ > 0);
  unlink(leaf);
  nodes_[leaf] = {};
  nodes_[leaf].parent = free_;
  free_ = leaf;
  --leaves_;
}

bool DynamicTree::move(Leaf leaf, const Aabb& box) {
  PROSECTOR_ASSERT(leaf < nodes_.size() && nodes_[leaf].leaf() && nodes_[leaf].user != nothing);
  const Aabb fat = box.grown(margin_);
  // Keeps the fat box while it contains the new box, unless the fat box has become much too large.
  if (nodes_[leaf].box.contains(box) && fat.grown(4 * margin_).contains(nodes_[leaf].box)) return false;
  unlink(leaf);
  nodes_[leaf].box = fat;
  link(leaf);
  return true;
}

std::uint32_t DynamicTree::best_sibling(const Aabb& box) const {
  PROSECTOR_ASSERT(root_ != nothing);
  std::uint32_t at = root_;
  while (!nodes_[at].leaf()) {
    const Node& node = nodes_[at];
    const double joined = around(node.box, box).area();
    const double here = 2 * joined, below = 2 * (joined - node.box.area());
    const auto cost = [&](const Node& child) {
      const double with = around(child.box, box).area();
      return below + (child.leaf() ? with : with - child.box.area());
    };
    const double left = cost(nodes_[node.left]), right = cost(nodes_[node.right]);
    if (here < left && here < right) break;
    at = left <= right ? node.left : node.right;
  }
  return at;
}

void DynamicTree::link(Leaf leaf) {
  if (root_ == nothing) {
    root_ = leaf;
    nodes_[leaf].parent = nothing;
    return;
  }
  const std::uint32_t sibling = best_sibling(nodes_[leaf].box);
  const std::uint32_t above = nodes_[sibling].parent;
  const std::uint32_t joint = take_node();
  nodes_[joint].parent = above;
  nodes_[joint].left = sibling;
  nodes_[joint].right = leaf;
  nodes_[sibling].parent = nodes_[leaf].parent = joint;
  if (above == nothing)
    root_ = joint;
  else
    (nodes_[above].left == sibling ? nodes_[above].left : nodes_[above].right) = joint;
  refit_from(joint);
}

void DynamicTree::unlink(Leaf leaf) {
  const std::uint32_t joint = nodes_[leaf].parent;
  if (joint == nothing) {
    root_ = nothing;
    return;
  }
  const std::uint32_t above = nodes_[joint].parent;
  const std::uint32_t sibling = nodes_[joint].left == leaf ? nodes_[joint].right : nodes_[joint].left;
  nodes_[sibling].parent = above;
  if (above == nothing)
    root_ = sibling;
  else
    (nodes_[above].left == joint ? nodes_[above].left : nodes_[above].right) = sibling;
  nodes_[joint] = {};
  nodes_[joint].parent = free_;
  free_ = joint;
  if (above != nothing) refit_from(above);
}

void DynamicTree::refit(std::uint32_t i) {
  PROSECTOR_ASSERT(!nodes_[i].leaf());
  Node& node = nodes_[i];
  node.box = around(nodes_[node.left].box, nodes_[node.right].box);
  node.height = 1 + std::max(nodes_[node.left].height, nodes_[node.right].height);
}

void DynamicTree::refit_from(std::uint32_t i) {
  for (; i != nothing; i = nodes_[i].parent) {
    refit(i);
    rotate(i);
  }
}

/// Swaps a child with a grandchild on the other side if that reduces the surface area of the node between
/// them.
void DynamicTree::rotate(std::uint32_t i) {
  double best_gain = 0;
  std::uint32_t child = nothing, other = nothing, grandchild = nothing;
  const auto consider = [&](std::uint32_t upper, std::uint32_t lower) {
    if (nodes_[lower].leaf()) return;
    const Node& inner = nodes_[lower];
    const double now = inner.box.area();
    for (const auto& [away, stays] :
         {std::pair{inner.left, inner.right}, std::pair{inner.right, inner.left}}) {
      const double gain = now - around(nodes_[upper].box, nodes_[stays].box).area();
      if (gain > best_gain) {
        best_gain = gain;
        child = upper;
        other = lower;
        grandchild = away;
      }
    }
  };
  consider(nodes_[i].left, nodes_[i].right);
  consider(nodes_[i].right, nodes_[i].left);
  if (child == nothing) return;
  (nodes_[i].left == child ? nodes_[i].left : nodes_[i].right) = grandchild;
  (nodes_[other].left == grandchild ? nodes_[other].left : nodes_[other].right) = child;
  nodes_[grandchild].parent = i;
  nodes_[child].parent = other;
  refit(other);
  refit(i);
}

}  // namespace prosector::collision
