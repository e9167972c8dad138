#include "client/render/curvature.h"

#include <algorithm>

namespace prosector {
namespace {

using TriangleSpan = std::span<const std::array<std::uint32_t, 3>>;

constexpr float scale = 0.004F;  // m
constexpr int rounds = 3;        // averaging passes

/// Calls add(a, b) for each edge of each triangle in both directions: for a vertex a and its neighbour b.
template <class Add>
void for_each_edge(TriangleSpan triangles, const Add& add) {
  for (const auto& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      add(t[k], t[(k + 1) % 3]);
      add(t[(k + 1) % 3], t[k]);
    }
}

std::vector<float> averaged(const std::vector<float>& values, TriangleSpan triangles) {
  std::vector<float> sum = values, weight(values.size(), 1.0F);
  for_each_edge(triangles, [&](std::uint32_t a, std::uint32_t b) {
    sum[a] += values[b];
    weight[a] += 1;
  });
  for (std::size_t v = 0; v < sum.size(); ++v) sum[v] /= weight[v];
  return sum;
}

}  // namespace

// Along an edge of length l from a point with normal n, a surface of curvature κ rises by κ l² / 2.
std::vector<float> curvature_of(std::span<const Eigen::Vector3f> points, TriangleSpan triangles) {
  std::vector<Eigen::Vector3f> normals(points.size(), Eigen::Vector3f::Zero());
  for (const auto& t : triangles) {
    const Eigen::Vector3f twice_area = (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]);
    for (const std::uint32_t v : t) normals[v] += twice_area;
  }
  for (Eigen::Vector3f& n : normals) n.normalize();
  std::vector<float> out(points.size(), 0.0F), squares(points.size(), 0.0F);
  for_each_edge(triangles, [&](std::uint32_t a, std::uint32_t b) {
    const Eigen::Vector3f edge = points[b] - points[a];
    out[a] += 2 * edge.dot(normals[a]);
    squares[a] += edge.squaredNorm();
  });
  for (std::size_t v = 0; v < out.size(); ++v)
    out[v] = squares[v] > 0 ? std::clamp(scale * out[v] / squares[v], -1.0F, 1.0F) : 0.0F;
  for (int round = 0; round < rounds; ++round) out = averaged(out, triangles);
  return out;
}

}  // namespace prosector
