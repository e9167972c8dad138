#include "client/view/edge_collapse.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

#include "client/view/triangle_point.h"

namespace prosector {
namespace {

using Vec3f = Eigen::Vector3f;

// Favours triangles of similar size where the surface is flat, because it may be bent later.
// Weight of the edge's squared length against the squared displacement.
constexpr float share_of_length = 1e-3F;
constexpr float least_cosine = 0.2F;  // between a triangle's normal before and after: 78°

Vec3f twice_area(const Vec3f& a, const Vec3f& b, const Vec3f& c) {
  return (b - a).cross(c - a);
}

bool has(const std::array<std::uint32_t, 3>& triangle, std::uint32_t v) {
  return triangle[0] == v || triangle[1] == v || triangle[2] == v;
}

}  // namespace

EdgeCollapser::EdgeCollapser(std::span<const Vec3f> positions, const Triangles& triangles)
    : at_(positions),
      triangles_(triangles),
      gone_(triangles.size(), false),
      left_(triangles.size()),
      around_(positions.size()),
      stays_(positions.size(), false),
      changed_(positions.size(), false),
      into_(positions.size()),
      moved_(positions.size(), 0) {
  std::iota(into_.begin(), into_.end(), 0U);
  for (std::uint32_t t = 0; t < triangles_.size(); ++t)
    for (const std::uint32_t v : triangles_[t]) around_[v].push_back(t);
  keep_borders();
  for (std::uint32_t v = 0; v < at_.size(); ++v) enqueue(v);
}

void EdgeCollapser::keep_borders() {
  std::unordered_map<std::uint64_t, int> uses;
  uses.reserve(2 * triangles_.size());
  const auto for_each_edge = [&](const auto& use) {
    for (const auto& t : triangles_)
      for (std::size_t k = 0; k < 3; ++k) use(std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3]));
  };
  for_each_edge([&](std::uint64_t low, std::uint64_t high) { ++uses[low << 32 | high]; });
  for_each_edge([&](std::uint64_t low, std::uint64_t high) {
    if (uses[low << 32 | high] != 2) stays_[low] = stays_[high] = true;
  });
}

/// Returns the neighbours of a vertex, ascending, each once.
std::vector<std::uint32_t> EdgeCollapser::neighbours(std::uint32_t v) const {
  std::vector<std::uint32_t> out;
  for (const std::uint32_t t : around_[v])
    if (!gone_[t])
      for (const std::uint32_t other : triangles_[t])
        if (other != v) out.push_back(other);
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

/// Queues the cheapest valid collapse of this vertex, if any.
void EdgeCollapser::enqueue(std::uint32_t from) {
  changed_[from] = false;
  if (stays_[from]) return;
  std::vector<Candidate> ways;
  for (const std::uint32_t into : neighbours(from)) ways.push_back(candidate(from, into));
  std::stable_sort(ways.begin(), ways.end(),
                   [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
  const auto best =
      std::ranges::find_if(ways, [&](const Candidate& way) { return may_collapse(way.from, way.into); });
  if (best != ways.end()) queue_.push(*best);
}

EdgeCollapser::Candidate EdgeCollapser::candidate(std::uint32_t from, std::uint32_t into) const {
  float nearest = (at_[from] - at_[into]).squaredNorm();
  const float length = nearest;
  for (const std::uint32_t t : around_[from]) {
    if (gone_[t] || has(triangles_[t], into)) continue;
    std::array<Vec3f, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = at_[triangles_[t][k] == from ? into : triangles_[t][k]];
    const Vec3f at = point_on_triangle_near(at_[from], corners[0], corners[1], corners[2]).at;
    nearest = std::min(nearest, (at_[from] - at).squaredNorm());
  }
  const float moved = moved_[from] + std::sqrt(nearest);
  return {moved * moved + share_of_length * length, moved, from, into};
}

/// Returns whether the collapse preserves the topology: the two vertices share exactly two neighbours, and no
/// triangle flips or loses its area.
bool EdgeCollapser::may_collapse(std::uint32_t from, std::uint32_t into) const {
  const auto near_from = neighbours(from), near_into = neighbours(into);
  std::vector<std::uint32_t> common;
  std::ranges::set_intersection(near_from, near_into, std::back_inserter(common));
  if (common.size() != 2) return false;
  return std::ranges::none_of(around_[from], [&](std::uint32_t t) {
    if (gone_[t] || has(triangles_[t], into)) return false;
    std::array<Vec3f, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = at_[triangles_[t][k]];
    const Vec3f before = twice_area(corners[0], corners[1], corners[2]);
    for (std::size_t k = 0; k < 3; ++k)
      if (triangles_[t][k] == from) corners[k] = at_[into];
    const Vec3f after = twice_area(corners[0], corners[1], corners[2]);
    return !(before.dot(after) > least_cosine * before.norm() * after.norm());
  });
}

void EdgeCollapser::collapse(const Candidate& edge) {
  const auto [from, into] = std::pair(edge.from, edge.into);
  for (const std::uint32_t t : around_[from]) {
    if (gone_[t]) continue;
    if (has(triangles_[t], into)) {
      gone_[t] = true;
      --left_;
      continue;
    }
    for (std::uint32_t& v : triangles_[t])
      if (v == from) v = into;
    around_[into].push_back(t);
  }
  std::erase_if(around_[into], [&](std::uint32_t t) { return gone_[t]; });
  around_[from] = {};
  moved_[into] = std::max(moved_[into], edge.moved);
  into_[from] = into;
  changed_[into] = true;
  for (const std::uint32_t v : neighbours(into)) changed_[v] = true;
}

bool EdgeCollapser::reduce_to(std::size_t triangles) {
  while (left_ > triangles) {
    if (queue_.empty()) return false;
    const Candidate best = queue_.top();
    queue_.pop();
    if (changed_[best.from] || !may_collapse(best.from, best.into))
      enqueue(best.from);
    else
      collapse(best);
  }
  return true;
}

std::uint32_t EdgeCollapser::replacement_of(std::uint32_t v) const {
  while (into_[v] != v) v = into_[v];
  return v;
}

}  // namespace prosector
