#include "client/view/surface_tree.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

namespace prosector {
namespace {

constexpr std::uint32_t leaf_triangles = 6;
constexpr std::size_t most_depth = 64;  // for a tree that halves its triangles at each level

std::array<Vec3, 3> corners_of(const DrawMesh& mesh, std::uint32_t triangle) {
  const auto& t = mesh.triangles[triangle];
  return {mesh.positions[t[0]].cast<double>(), mesh.positions[t[1]].cast<double>(),
          mesh.positions[t[2]].cast<double>()};
}

/// Returns whether the ray passes through the box nearer than `nearest`.
bool passes(const Ray& ray, const Vec3& inverse, const Eigen::AlignedBox3f& box, double nearest) {
  const Vec3 a = (box.min().cast<double>() - ray.from).cwiseProduct(inverse);
  const Vec3 b = (box.max().cast<double>() - ray.from).cwiseProduct(inverse);
  const double enters = a.cwiseMin(b).maxCoeff(), leaves = a.cwiseMax(b).minCoeff();
  constexpr double slack = 1e-6;  // m: boxes of flat meshes have no thickness
  return leaves >= 0 && enters <= leaves + slack && enters < nearest;
}

/// Returns the reciprocal of the direction per component, large but finite for zero components.
Vec3 inverse_of(const Vec3& along) {
  return along.unaryExpr([](double x) { return std::abs(x) > 1e-12 ? 1 / x : std::copysign(1e12, x); });
}

}  // namespace

void SurfaceTree::follow(const DrawMesh& mesh) {
  if (revision_ != mesh.revision || order_.size() != mesh.triangles.size()) {
    sort(mesh);
    revision_ = mesh.revision;
    positions_revision_.reset();
  }
  if (positions_revision_ == mesh.positions_revision) return;
  fit(mesh);
  positions_revision_ = mesh.positions_revision;
}

void SurfaceTree::sort(const DrawMesh& mesh) {
  nodes_.clear();
  order_.resize(mesh.triangles.size());
  std::iota(order_.begin(), order_.end(), 0U);
  std::vector<Eigen::Vector3f> middles;
  middles.reserve(order_.size());
  for (const auto& t : mesh.triangles)
    middles.push_back((mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3);
  if (!order_.empty()) divide(middles, 0, static_cast<std::uint32_t>(order_.size()));
}

void SurfaceTree::divide(const std::vector<Eigen::Vector3f>& middles, std::uint32_t first,
                         std::uint32_t count) {
  const std::size_t node = nodes_.size();
  nodes_.push_back({.box = {}, .first = first, .count = count});
  if (count <= leaf_triangles) return;
  Eigen::AlignedBox3f box;
  for (std::uint32_t k = first; k < first + count; ++k) box.extend(middles[order_[k]]);
  Eigen::Index axis = 0;
  box.sizes().maxCoeff(&axis);
  const std::uint32_t half = count / 2;
  std::nth_element(order_.begin() + first, order_.begin() + first + half, order_.begin() + first + count,
                   [&](std::uint32_t a, std::uint32_t b) { return middles[a][axis] < middles[b][axis]; });
  divide(middles, first, half);
  nodes_[node].other = static_cast<std::uint32_t>(nodes_.size());
  nodes_[node].count = 0;
  divide(middles, first + half, count - half);
}

void SurfaceTree::fit(const DrawMesh& mesh) {
  for (std::size_t k = nodes_.size(); k-- > 0;) {
    Node& node = nodes_[k];
    node.box.setEmpty();
    if (node.count == 0) {
      node.box.extend(nodes_[k + 1].box);
      node.box.extend(nodes_[node.other].box);
    }
    for (std::uint32_t t = node.first; t < node.first + node.count; ++t)
      for (const std::uint32_t corner : mesh.triangles[order_[t]]) node.box.extend(mesh.positions[corner]);
  }
}

std::optional<SurfaceTree::Hit> SurfaceTree::meet(const DrawMesh& mesh, const Ray& ray) const {
  std::optional<Hit> nearest;
  if (nodes_.empty()) return nearest;
  const Vec3 inverse = inverse_of(ray.along);
  std::array<std::uint32_t, most_depth> waiting{};
  std::size_t count = 1;
  while (count > 0) {
    const std::uint32_t k = waiting[--count];
    const Node& node = nodes_[k];
    const double least = nearest ? nearest->distance : std::numeric_limits<double>::infinity();
    if (!passes(ray, inverse, node.box, least)) continue;
    if (node.count == 0 && count + 2 <= most_depth) {
      waiting[count++] = node.other;
      waiting[count++] = k + 1;
    }
    for (std::uint32_t t = node.first; t < node.first + node.count; ++t) {
      const auto [a, b, c] = corners_of(mesh, order_[t]);
      if (const auto d = prosector::meet(ray, a, b, c); d && (!nearest || *d < nearest->distance))
        nearest = Hit{*d, order_[t]};
    }
  }
  return nearest;
}

std::optional<SurfacePoint> SurfaceTrees::meet(const Ray& ray, const DrawItem& item) {
  if (!item.mesh || std::abs(item.shape.A.determinant()) < 1e-12) return std::nullopt;
  SurfaceTree& tree = trees_[item.mesh->id];
  tree.follow(*item.mesh);
  const Mat3 unshape = item.shape.A.inverse();
  const Pose into = item.pose.inverse();
  const Ray local{into * Vec3(unshape * (ray.from - item.shape.p)), into.q * Vec3(unshape * ray.along)};
  const auto hit = tree.meet(*item.mesh, local);
  if (!hit) return std::nullopt;
  const auto [a, b, c] = corners_of(*item.mesh, hit->triangle);
  const Mat3 room_from_mesh = item.shape.A * item.pose.q.toRotationMatrix();
  const Vec3 normal = room_from_mesh.inverse().transpose() * (b - a).cross(c - a);
  return SurfacePoint{hit->distance, ray.from + hit->distance * ray.along, normal.normalized()};
}

}  // namespace prosector
