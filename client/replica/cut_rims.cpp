#include "client/replica/cut_rims.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace prosector {
namespace {

constexpr double same_place = 1e-5;  // m: what is nearer at rest was one before the cut

using Corners = std::array<std::uint32_t, 3>;

/// An edge as a triangle runs along it.
struct HalfEdge {
  std::uint64_t key;  // its vertices, the lower one first
  std::uint32_t a, b;
};

bool is_gone(const Corners& t) {
  return t[0] == t[1] && t[1] == t[2];
}

void add_half_edges(const Corners& t, std::vector<HalfEdge>& out) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t a = t[i], b = t[(i + 1) % 3];
    out.push_back({std::uint64_t{std::min(a, b)} << 32 | std::max(a, b), a, b});
  }
}

void sort_by_key(std::vector<HalfEdge>& edges) {
  std::sort(edges.begin(), edges.end(), [](const HalfEdge& x, const HalfEdge& y) { return x.key < y.key; });
}

std::vector<CutRim> rims_of_walls(const TriangleMesh& rest) {
  std::vector<std::uint8_t> at_wall(rest.positions.size(), 0);
  std::vector<HalfEdge> walls, outside;
  for (std::size_t t = 0; t < rest.triangles.size(); ++t) {
    if (rest.inner[t] == 0 || is_gone(rest.triangles[t])) continue;
    for (const std::uint32_t v : rest.triangles[t]) at_wall[v] = 1;
    add_half_edges(rest.triangles[t], walls);
  }
  for (std::size_t t = 0; t < rest.triangles.size(); ++t) {
    const Corners& c = rest.triangles[t];
    const int touching = at_wall[c[0]] + at_wall[c[1]] + at_wall[c[2]];
    if (rest.inner[t] == 0 && !is_gone(c) && touching >= 2) add_half_edges(c, outside);
  }
  sort_by_key(walls);
  std::vector<CutRim> out;
  for (const HalfEdge& edge : outside) {
    const auto before = [](const HalfEdge& wall, std::uint64_t key) { return wall.key < key; };
    const auto found = std::lower_bound(walls.begin(), walls.end(), edge.key, before);
    if (found != walls.end() && found->key == edge.key) out.push_back({edge.a, edge.b});
  }
  return out;
}

std::vector<CutRim> borders(const TriangleMesh& rest) {
  std::vector<HalfEdge> edges;
  for (const Corners& t : rest.triangles)
    if (!is_gone(t)) add_half_edges(t, edges);
  sort_by_key(edges);
  std::vector<CutRim> out;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const bool alone = (i == 0 || edges[i - 1].key != edges[i].key) &&
                       (i + 1 == edges.size() || edges[i + 1].key != edges[i].key);
    if (alone) out.push_back({edges[i].a, edges[i].b});
  }
  return out;
}

}  // namespace

std::vector<CutRim> cut_rims(const TriangleMesh& rest) {
  const bool has_walls = std::ranges::find(rest.inner, std::uint8_t{1}) != rest.inner.end();
  return has_walls ? rims_of_walls(rest) : borders(rest);
}

std::vector<std::optional<std::size_t>> other_sides(const std::vector<RestEdge>& edges) {
  std::vector<std::size_t> order(edges.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto middle = [&](std::size_t k) -> Vec3 { return (edges[k].a + edges[k].b) / 2; };
  std::sort(order.begin(), order.end(),
            [&](std::size_t x, std::size_t y) { return middle(x).x() < middle(y).x(); });
  const auto same = [](const Vec3& x, const Vec3& y) { return (x - y).norm() < same_place; };
  std::vector<std::optional<std::size_t>> out(edges.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const RestEdge& edge = edges[order[i]];
    for (std::size_t j = i + 1; j < order.size() && !out[order[i]]; ++j) {
      if (middle(order[j]).x() - middle(order[i]).x() > same_place) break;
      const RestEdge& other = edges[order[j]];
      const bool twin = (same(edge.a, other.b) && same(edge.b, other.a)) ||
                        (same(edge.a, other.a) && same(edge.b, other.b));
      if (out[order[j]] || !twin) continue;
      out[order[i]] = order[j];
      out[order[j]] = order[i];
    }
  }
  return out;
}

}  // namespace prosector
