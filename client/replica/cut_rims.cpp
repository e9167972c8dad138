#include "client/replica/cut_rims.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace prosector {
namespace {

constexpr double same_place = 1e-5;  // m: points nearer than this at rest coincided before the cut

using Corners = std::array<std::uint32_t, 3>;

/// An edge in the direction of its triangle's orientation; `beside` is the triangle's third vertex.
struct HalfEdge {
  std::uint64_t key;  // its vertices, the lower index in the upper 32 bits
  std::uint32_t a, b, beside;
};

bool is_gone(const Corners& t) {
  return t[0] == t[1] && t[1] == t[2];
}

void add_half_edges(const Corners& t, std::vector<HalfEdge>& out) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t a = t[i], b = t[(i + 1) % 3];
    out.push_back({std::uint64_t{std::min(a, b)} << 32 | std::max(a, b), a, b, t[(i + 2) % 3]});
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

/// Removes duplicates among coinciding edges of a sheet's front and back.
void drop_backs(std::vector<HalfEdge>& edges, const TriangleMesh& rest) {
  const auto middle = [&](const HalfEdge& e) -> Vec3 {
    return (rest.positions[e.a] + rest.positions[e.b]) / 2;
  };
  std::sort(edges.begin(), edges.end(),
            [&](const HalfEdge& x, const HalfEdge& y) { return middle(x).x() < middle(y).x(); });
  const auto same = [&](std::uint32_t v, std::uint32_t w) {
    return (rest.positions[v] - rest.positions[w]).norm() < same_place;
  };
  std::vector<bool> is_back(edges.size(), false);
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      if (middle(edges[j]).x() - middle(edges[i]).x() > same_place) break;
      const bool turned = same(edges[i].a, edges[j].b) && same(edges[i].b, edges[j].a);
      if (turned && same(edges[i].beside, edges[j].beside)) is_back[j] = !is_back[i];
    }
  std::size_t k = 0;
  std::erase_if(edges, [&](const HalfEdge&) { return is_back[k++]; });
}

std::vector<CutRim> borders(const TriangleMesh& rest) {
  std::vector<HalfEdge> edges, alone;
  for (const Corners& t : rest.triangles)
    if (!is_gone(t)) add_half_edges(t, edges);
  sort_by_key(edges);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const bool is_alone = (i == 0 || edges[i - 1].key != edges[i].key) &&
                          (i + 1 == edges.size() || edges[i + 1].key != edges[i].key);
    if (is_alone) alone.push_back(edges[i]);
  }
  drop_backs(alone, rest);
  std::vector<CutRim> out;
  for (const HalfEdge& edge : alone) out.push_back({edge.a, edge.b});
  return out;
}

Vec3 middle_of(const RestEdge& edge) {
  return (edge.a + edge.b) / 2;
}

/// Returns the position of `edge`'s midpoint on `whole` as a fraction of its length; nullopt: they do not
/// overlap on one line.
std::optional<double> share_at(const RestEdge& edge, const RestEdge& whole) {
  const Vec3 along = whole.b - whole.a;
  const double length = along.norm();
  if (!(length > same_place)) return std::nullopt;
  const double at = (middle_of(edge) - whole.a).dot(along) / length;
  const auto off = [&](const Vec3& x) { return (x - whole.a).cross(along).norm() / length; };
  const bool beside = at < -same_place || at > length + same_place;
  if (beside || off(edge.a) > same_place || off(edge.b) > same_place) return std::nullopt;
  return std::clamp(at / length, 0.0, 1.0);
}

/// Finds the opposite edges of those without an identical twin.
void find_parted(const std::vector<RestEdge>& edges, std::vector<std::optional<OtherSide>>& sides) {
  std::vector<std::size_t> alone;
  for (std::size_t k = 0; k < edges.size(); ++k)
    if (!sides[k]) alone.push_back(k);
  for (const std::size_t k : alone)
    for (const std::size_t other : alone) {
      if (other == k) continue;
      const auto share = share_at(edges[k], edges[other]);
      if (share) sides[k] = OtherSide{other, *share};
      if (share) break;
    }
}

}  // namespace

std::vector<CutRim> cut_rims(const TriangleMesh& rest) {
  const bool has_walls = std::ranges::find(rest.inner, std::uint8_t{1}) != rest.inner.end();
  return has_walls ? rims_of_walls(rest) : borders(rest);
}

std::vector<std::optional<OtherSide>> other_sides(const std::vector<RestEdge>& edges) {
  std::vector<std::size_t> order(edges.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t x, std::size_t y) { return middle_of(edges[x]).x() < middle_of(edges[y]).x(); });
  const auto same = [](const Vec3& x, const Vec3& y) { return (x - y).norm() < same_place; };
  std::vector<std::optional<OtherSide>> out(edges.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const RestEdge& edge = edges[order[i]];
    for (std::size_t j = i + 1; j < order.size() && !out[order[i]]; ++j) {
      const RestEdge& other = edges[order[j]];
      if (middle_of(other).x() - middle_of(edge).x() > same_place) break;
      const bool twin = (same(edge.a, other.b) && same(edge.b, other.a)) ||
                        (same(edge.a, other.a) && same(edge.b, other.b));
      if (out[order[j]] || !twin) continue;
      out[order[i]] = OtherSide{order[j]};
      out[order[j]] = OtherSide{order[i]};
    }
  }
  find_parted(edges, out);
  return out;
}

}  // namespace prosector
