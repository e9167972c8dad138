#include "server/physics/mechanics/organs/blade.h"

#include <algorithm>
#include <cmath>

namespace prosector::organs {

BladeShape blade_shape(const std::vector<EdgeDesc>& edges) {
  BladeShape out;
  for (const EdgeDesc& edge : edges) {
    const Vec3 along = edge.to - edge.from;
    const int pieces = edge.ray ? 1 : std::max(1, static_cast<int>(std::ceil(along.norm() / edge_spacing)));
    BladeShape::Edge& made = out.edges.emplace_back();
    for (int i = 0; i <= pieces; ++i) made.points.push_back(edge.from + i * along / pieces);
    made.length_per_point = along.norm() / (pieces + 1);
    made.direction = along.normalized();
    made.ray = edge.ray;
  }
  return out;
}

namespace {

/// Returns the fraction of its force bound that a lagging point bears. `parted` (m): part of the lag that
/// separates tissue.
double slicing(double lag, double parted) {
  constexpr double least = 1e-3;
  const double gone = std::min(1.0, lag / edge_give);
  if (!(lag > 0)) return 1;
  return std::clamp(1 - gone * gone * (1 - parted / lag), least, 1.0);
}

}  // namespace

Vec3 point_of(const SparseMap::Row& row, const VecX& x) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < row.node.size(); ++k)
    sum += row.weight[k] * x.segment<3>(3 * Eigen::Index{row.node[k]});
  return sum;
}

double slicing(const Vec3& lag, const Vec3& edge) {
  return slicing(lag.norm(), lag.cross(edge).norm());
}

double slicing(const Vec3& lag, const Vec3& edge, const Vec3& normal) {
  constexpr double along_it = 1e-6;  // cosine of an edge that is treated as lying in the sheet
  const double through = std::max(along_it, std::abs(edge.dot(normal)));
  return slicing(lag.norm(), normal.cross(lag.cross(edge)).norm() / through);
}

}  // namespace prosector::organs
