#include "server/physics/organs/blade.h"

#include <algorithm>
#include <cmath>

namespace prosector {

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

double slicing(const Vec3& lag, const Vec3& edge) {
  constexpr double least = 1e-3;
  const double length = lag.norm(), gone = std::min(1.0, length / edge_give);
  if (!(length > 0)) return 1;
  return std::clamp(1 - gone * gone * (1 - lag.cross(edge).norm() / length), least, 1.0);
}

}  // namespace prosector
