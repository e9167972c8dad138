#include "client/view/wireframe.h"

#include <map>

namespace prosector {
namespace {

constexpr double flat = 0.9998;  // cosine of the largest angle between normals of coplanar faces: 1.1°

std::array<std::uint32_t, 2> edge_of(std::uint32_t a, std::uint32_t b) {
  return {std::min(a, b), std::max(a, b)};
}

}  // namespace

Edges visible_edges(const TriangleMesh& mesh) {
  std::map<std::array<std::uint32_t, 2>, std::vector<Vec3>> normals;
  for (const auto& t : mesh.triangles) {
    const Vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    const Vec3 normal = (b - a).cross(c - a).stableNormalized();
    for (std::size_t k = 0; k < 3; ++k) normals[edge_of(t[k], t[(k + 1) % 3])].push_back(normal);
  }
  Edges out;
  for (const auto& [edge, faces] : normals)
    if (faces.size() != 2 || faces[0].dot(faces[1]) < flat) out.push_back(edge);
  return out;
}

Edges all_edges(const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  std::map<std::array<std::uint32_t, 2>, bool> seen;
  for (const auto& t : triangles)
    for (std::size_t k = 0; k < 3; ++k)
      if (t[k] != t[(k + 1) % 3]) seen[edge_of(t[k], t[(k + 1) % 3])] = true;
  Edges out;
  for (const auto& [edge, _] : seen) out.push_back(edge);
  return out;
}

}  // namespace prosector
