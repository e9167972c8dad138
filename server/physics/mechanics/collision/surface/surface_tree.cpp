#include "server/physics/mechanics/collision/surface/surface_tree.h"

#include "common/assert.h"

namespace prosector::collision {

SurfaceTree::SurfaceTree(std::span<const Corners> triangles, std::span<const Vec3> positions)
    : order_(triangles.size()) {
  std::iota(order_.begin(), order_.end(), 0u);
  std::vector<Vec3> centroids;
  centroids.reserve(triangles.size());
  for (const Corners& t : triangles)
    centroids.push_back((positions[t[0]] + positions[t[1]] + positions[t[2]]) / 3);
  nodes_.reserve(triangles.size());
  const auto at_median = [&](std::uint32_t begin, std::uint32_t middle, std::uint32_t end) {
    Aabb box;
    for (std::uint32_t i = begin; i < end; ++i) box.add(centroids[order_[i]]);
    Eigen::Index axis = 0;
    (box.hi - box.lo).maxCoeff(&axis);
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) {
                       const double x = centroids[a][axis], y = centroids[b][axis];
                       return x != y ? x < y : a < b;
                     });
  };
  if (!order_.empty()) build(0, static_cast<std::uint32_t>(order_.size()), at_median);
  nodes_.shrink_to_fit();
  refit(triangles, positions);
}

SurfaceTree::SurfaceTree(std::span<const Corners> triangles, std::span<const Vec3> positions,
                         std::span<const std::uint32_t> order)
    : order_(order.begin(), order.end()) {
  PROSECTOR_ASSERT(order_.size() == triangles.size());
  nodes_.reserve(order_.size());
  const auto as_it_is = [](std::uint32_t, std::uint32_t, std::uint32_t) {};
  if (!order_.empty()) build(0, static_cast<std::uint32_t>(order_.size()), as_it_is);
  refit(triangles, positions);
}

/// Builds the node of a run of triangles. `halve`: partitions the run so that its first half precedes
/// `middle`.
template <class F>
std::uint32_t SurfaceTree::build(std::uint32_t begin, std::uint32_t end, const F& halve) {
  PROSECTOR_ASSERT(begin < end && end <= order_.size());
  const auto at = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({{}, begin, end, 0});
  if (end - begin <= leaf_triangles) return at;
  const std::uint32_t middle = begin + (end - begin) / 2;
  halve(begin, middle, end);
  build(begin, middle, halve);
  nodes_[at].right = build(middle, end, halve);
  return at;
}

void SurfaceTree::refit(std::span<const Corners> triangles, std::span<const Vec3> positions) {
  PROSECTOR_ASSERT(order_.size() == triangles.size());
  for (std::size_t i = nodes_.size(); i-- > 0;) {
    Node& node = nodes_[i];
    node.box = {};
    if (!node.leaf()) {
      node.box.add(nodes_[i + 1].box);
      node.box.add(nodes_[node.right].box);
      continue;
    }
    for (std::uint32_t k = node.begin; k < node.end; ++k)
      for (const std::uint32_t v : triangles[order_[k]]) node.box.add(positions[v]);
  }
}

}  // namespace prosector::collision
