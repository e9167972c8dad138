#include "common/anatomy/surface_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "common/anatomy/mesh_quality.h"

namespace prosector {
namespace {

using Corners = std::array<Vec3, 3>;

// Returns whether segment p–q passes through the interior of triangle t (touching its border doesn't count).
bool pierces(const Vec3& p, const Vec3& q, const Corners& t) {
  const auto side = [](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return tet_volume(a, b, c, d);
  };
  const double sp = side(t[0], t[1], t[2], p), sq = side(t[0], t[1], t[2], q);
  if (!(sp * sq < 0)) return false;
  const double a = side(p, q, t[0], t[1]), b = side(p, q, t[1], t[2]), c = side(p, q, t[2], t[0]);
  return (a > 0 && b > 0 && c > 0) || (a < 0 && b < 0 && c < 0);
}

bool cross_each_other(const Corners& s, const Corners& t) {
  for (std::size_t k = 0; k < 3; ++k)
    if (pierces(s[k], s[(k + 1) % 3], t) || pierces(t[k], t[(k + 1) % 3], s)) return true;
  return false;
}

}  // namespace

std::vector<std::array<std::uint32_t, 2>> intersecting_triangles(const TriangleMesh& mesh) {
  // Sweep and prune along x over the triangles' bounding boxes.
  struct Item {
    Vec3 low, high;
    std::uint32_t triangle;
  };
  std::vector<Item> items;
  items.reserve(mesh.triangles.size());
  const auto corners = [&](std::uint32_t t) {
    Corners out;
    for (std::size_t k = 0; k < 3; ++k) out[k] = mesh.positions[mesh.triangles[t][k]];
    return out;
  };
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const Corners c = corners(t);
    items.push_back({c[0].cwiseMin(c[1]).cwiseMin(c[2]), c[0].cwiseMax(c[1]).cwiseMax(c[2]), t});
  }
  std::sort(items.begin(), items.end(), [](const Item& a, const Item& b) { return a.low[0] < b.low[0]; });
  std::vector<std::array<std::uint32_t, 2>> out;
  for (std::size_t i = 0; i < items.size(); ++i)
    for (std::size_t j = i + 1; j < items.size() && items[j].low[0] <= items[i].high[0]; ++j) {
      if ((items[j].low.array() > items[i].high.array()).any() ||
          (items[i].low.array() > items[j].high.array()).any())
        continue;
      const auto& s = mesh.triangles[items[i].triangle];
      const auto& t = mesh.triangles[items[j].triangle];
      if (std::find_first_of(s.begin(), s.end(), t.begin(), t.end()) != s.end()) continue;
      if (cross_each_other(corners(items[i].triangle), corners(items[j].triangle)))
        out.push_back({items[i].triangle, items[j].triangle});
    }
  return out;
}

SurfaceReport check_surface(const TriangleMesh& mesh) {
  SurfaceReport out;
  out.open_edges = non_manifold_edges(mesh.triangles);
  out.intersecting_pairs = intersecting_triangles(mesh).size();
  Mat3 second = Mat3::Zero();  // ∫ x xᵀ dV, from tetrahedra with a common reference point
  if (mesh.positions.empty()) return out;
  const Vec3 reference = mesh.positions.front();
  Vec3 first = Vec3::Zero();
  for (const auto& t : mesh.triangles) {
    Mat3 x;
    for (std::size_t k = 0; k < 3; ++k) x.col(static_cast<int>(k)) = mesh.positions[t[k]] - reference;
    const double volume = x.determinant() / 6;
    const Vec3 sum = x.rowwise().sum();
    out.volume += volume;
    first += volume / 4 * sum;
    second += volume / 20 * (x * x.transpose() + sum * sum.transpose());
  }
  if (out.volume == 0) return out;
  const Vec3 center = first / out.volume;
  out.center_of_mass = reference + center;
  const Mat3 central = second - out.volume * center * center.transpose();
  out.inertia = central.trace() * Mat3::Identity() - central;
  return out;
}

std::string SurfaceReport::warning() const {
  std::string out;
  const auto add = [&](const std::string& text) { out += (out.empty() ? "" : "; ") + text; };
  if (open_edges > 0)
    add(fmt::format("not closed: the surface has {} open or non-manifold edges", open_edges));
  if (intersecting_pairs > 0)
    add(fmt::format("intersects itself: {} pairs of the surface's triangles cross", intersecting_pairs));
  if (volume < 0) add("its triangles face inward");
  return out;
}

}  // namespace prosector
