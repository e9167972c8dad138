#include "common/anatomy/winding_tree.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace prosector {
namespace {

constexpr std::size_t leaf_size = 8;
constexpr double far = 3;  // distance from a node's centre, in node radii, beyond which the dipole is used

/// Returns the solid angle of a triangle (Van Oosterom & Strackee 1983), positive if it faces away from the
/// origin.
double solid_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  return 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

}  // namespace

WindingTree::WindingTree(const TriangleMesh& surface) {
  corners_.reserve(surface.triangles.size());
  for (const auto& t : surface.triangles)
    corners_.push_back({surface.positions[t[0]], surface.positions[t[1]], surface.positions[t[2]]});
  if (!corners_.empty()) grow(0, corners_.size());
}

std::uint32_t WindingTree::grow(std::size_t begin, std::size_t end) {
  const auto self = static_cast<std::uint32_t>(nodes_.size());
  Node node;
  node.begin = begin;
  node.end = end;
  Eigen::AlignedBox3d middles;
  double weight = 0;
  for (std::size_t i = begin; i < end; ++i) {
    const Corners& t = corners_[i];
    const Vec3 area = 0.5 * (t.b - t.a).cross(t.c - t.a);
    node.area += area;
    node.center += area.norm() * t.middle();
    weight += area.norm();
    middles.extend(t.middle());
  }
  node.center = weight > 0 ? Vec3(node.center / weight) : middles.center();
  for (std::size_t i = begin; i < end; ++i)
    for (const Vec3& x : {corners_[i].a, corners_[i].b, corners_[i].c})
      node.radius = std::max(node.radius, (x - node.center).norm());
  nodes_.push_back(node);
  if (end - begin <= leaf_size) return self;
  int axis = 0;
  middles.sizes().maxCoeff(&axis);
  const std::size_t half = begin + (end - begin) / 2;
  const auto at = [&](std::size_t i) { return corners_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(half), at(end),
                   [&](const Corners& s, const Corners& t) { return s.middle()[axis] < t.middle()[axis]; });
  grow(begin, half);
  const std::uint32_t right = grow(half, end);
  nodes_[self].right = right;
  return self;
}

double WindingTree::at(const Vec3& x) const {
  double sum = 0;
  std::vector<std::uint32_t> open;
  if (!nodes_.empty()) open.push_back(0);
  while (!open.empty()) {
    const std::uint32_t self = open.back();
    const Node& node = nodes_[self];
    open.pop_back();
    const Vec3 to = node.center - x;
    const double distance = to.norm();
    if (distance > far * node.radius && distance > 0) {
      sum += node.area.dot(to) / (distance * distance * distance);
    } else if (node.right == 0) {
      for (std::size_t i = node.begin; i < node.end; ++i)
        sum += solid_angle(corners_[i].a - x, corners_[i].b - x, corners_[i].c - x);
    } else {
      open.push_back(node.right);
      open.push_back(self + 1);
    }
  }
  return sum / (4 * std::numbers::pi);
}

}  // namespace prosector
