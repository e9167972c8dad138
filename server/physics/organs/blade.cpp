#include "server/physics/organs/blade.h"

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

}  // namespace prosector
