#include "server/physics/mechanics/cutting/blade_stroke.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "common/assert.h"
#include "common/error.h"
#include "server/physics/mechanics/cutting/tet_tree.h"

namespace prosector::cutting {
namespace {

using EdgePoint = BladeStroke::EdgePoint;

constexpr double rounding = 1e-9;  // relative to the parameter range of the segment

/// Part of the segment from a to b inside a tetrahedron. Barycentric weights at parameter s: w(s) = start + s
/// · way, all ≥ 0 between `begin` and `end`.
struct Stretch {
  double begin = 0, end = 1;
  TetId tet = TetComplex::none;
  Eigen::Vector4d start, way;
  std::array<double, 4> weights(double s) const {
    const Eigen::Vector4d w = start + s * way;
    return {w[0], w[1], w[2], w[3]};
  }
  bool operator<(const Stretch& o) const { return begin != o.begin ? begin < o.begin : tet < o.tet; }
};

/// Returns the part of the segment a–b inside a tetrahedron; none if the segment misses the tetrahedron, or
/// if the tetrahedron is flat.
std::optional<Stretch> stretch_in(const TetComplex& complex, TetId tet, std::span<const Vec3> positions,
                                  const Vec3& a, const Vec3& b) {
  PROSECTOR_ASSERT(complex.has_tet(tet) && !complex.is_sheet());
  const auto& c = complex.corners(tet);
  Mat3 edges;
  for (int k = 0; k < 3; ++k) edges.col(k) = positions[c[static_cast<std::size_t>(k) + 1]] - positions[c[0]];
  const Mat3 inverse = edges.inverse();
  const Vec3 w = inverse * (a - positions[c[0]]), d = inverse * (b - a);
  Stretch out;
  out.tet = tet;
  out.start = {1 - w.sum(), w[0], w[1], w[2]};
  out.way = {-d.sum(), d[0], d[1], d[2]};
  if (!out.start.allFinite() || !out.way.allFinite()) return std::nullopt;
  for (int k = 0; k < 4; ++k) {
    const double from = out.start[k], to = from + out.way[k];
    if (from < 0 && to < 0) return std::nullopt;
    if (from < 0) out.begin = std::max(out.begin, from / (from - to));
    if (to < 0) out.end = std::min(out.end, from / (from - to));
  }
  if (out.end < out.begin) return std::nullopt;
  return out;
}

/// Finds the parts of the segment inside tetrahedra, in order along the segment. Skips parts contained in
/// others.
void find_stretches(const TetComplex& complex, const TetTree& tree, std::span<const Vec3> positions,
                    const Vec3& a, const Vec3& b, std::vector<TetId>& near, std::vector<Stretch>& out) {
  near.clear();
  out.clear();
  tree.query(a.cwiseMin(b), a.cwiseMax(b), near);
  for (std::size_t n = 0; n < near.size(); ++n)
    if (!complex.has_tet(near[n])) {
      PROSECTOR_ASSERT(complex.lineage(near[n]).child != TetComplex::none);
      near.push_back(complex.lineage(near[n]).child);
      near.push_back(near.back() + 1);
    }
  for (const TetId t : near)
    if (complex.has_tet(t))
      if (const auto found = stretch_in(complex, t, positions, a, b)) out.push_back(*found);
  std::sort(out.begin(), out.end());
  double end = -1;
  std::erase_if(out, [&](Stretch& s) {
    s.begin = std::max(s.begin, end);
    if (s.end <= s.begin + (end < 0 ? 0 : rounding)) return end >= 0 || s.end < s.begin;
    end = s.end;
    return false;
  });
}

bool are_neighbors(const TetComplex& complex, TetId a, TetId b) {
  for (std::size_t k = 0; k < complex.sides(); ++k)
    if (complex.neighbor(a, k) == b) return true;
  return false;
}

/// Returns the point of the blade's edge at position `at`, counted in points of the edge.
Vec3 point_at(std::span<const Vec3> edge, double at) {
  PROSECTOR_ASSERT(edge.size() >= 2);
  const std::size_t k = std::min(static_cast<std::size_t>(at), edge.size() - 2);
  return edge[k] + (at - static_cast<double>(k)) * (edge[k + 1] - edge[k]);
}

/// Extends the line along the stretches `way` from its last point to `to`. Adds a point wherever the line
/// enters or leaves a tetrahedron. Attaches `to` to the tetrahedron that contains it, unless it is attached
/// already. `from_is_held`: the last point stays attached to its tetrahedron.
void go_on(std::vector<EdgePoint>& line, bool from_is_held, EdgePoint to, const std::vector<Stretch>& way,
           const TetComplex& complex) {
  PROSECTOR_ASSERT(!line.empty());
  const EdgePoint from = line.back();
  const auto put = [](EdgePoint& point, const Stretch& s, double share) {
    point.tet = s.tet;
    point.weight = s.weights(share);
  };
  const auto add = [&](const Stretch& s, double share) {
    EdgePoint& made = line.emplace_back();
    made.at = from.at + share * (to.at - from.at);
    made.room = from.room + share * (to.room - from.room);
    put(made, s, share);
  };
  double reached = 0;
  for (const Stretch& s : way) {
    bool continues = s.begin <= reached + rounding;
    if (continues && line.back().tet == TetComplex::none) put(line.back(), s, s.begin);
    if (continues) {
      const TetId last = line.back().tet;
      continues = (reached == 0 && from_is_held) || last == s.tet || are_neighbors(complex, last, s.tet);
    }
    if (!continues) add(s, s.begin);
    if (s.end < 1 - rounding)
      add(s, s.end);
    else if (to.tet == TetComplex::none)
      put(to, s, 1);
    reached = s.end;
  }
  line.push_back(to);
}

}  // namespace

void check_edge(std::span<const Vec3> edge) {
  if (edge.size() < 2)
    throw InputError(fmt::format("blade: its edge has {} points; allowed: 2 or more", edge.size()));
  for (std::size_t i = 0; i < edge.size(); ++i)
    if (!is_finite(edge[i]))
      throw InputError(
          fmt::format("blade: point {} of its edge is not finite; allowed: finite coordinates, in m", i));
}

BladeStroke begin_stroke(std::span<const Vec3> edge) {
  check_edge(edge);
  BladeStroke stroke;
  for (const Vec3& x : edge)
    stroke.edge.push_back({.at = static_cast<double>(stroke.edge.size()), .room = x});
  return stroke;
}

std::vector<Vec3> carried_edge(const BladeStroke& stroke, std::span<const Vec3> edge,
                               const TetComplex& complex, std::span<const Vec3> positions) {
  PROSECTOR_ASSERT(positions.size() >= complex.node_end() && edge.size() == stroke.points());
  const std::vector<EdgePoint>& line = stroke.edge;
  std::vector<Vec3> out(line.size());
  std::vector<std::size_t> tied;
  for (std::size_t i = 0; i < line.size(); ++i) {
    out[i] = line[i].room;
    if (!complex.has_tet(line[i].tet)) continue;
    out[i].setZero();
    for (std::size_t k = 0; k < 4; ++k)
      out[i] += line[i].weight[k] * positions[complex.corners(line[i].tet)[k]];
    tied.push_back(i);
  }
  if (tied.empty()) return out;
  for (std::size_t i = 0, next = 0; i < line.size(); ++i) {
    if (next < tied.size() && tied[next] == i) {
      ++next;
      continue;
    }
    const bool is_last = next == tied.size();
    const bool is_behind =
        is_last || (next > 0 && line[i].at - line[tied[next - 1]].at <= line[tied[next]].at - line[i].at);
    const std::size_t nearest = is_behind ? tied[next - 1] : tied[next];
    const Vec3 drift = out[nearest] - line[nearest].room, goal = point_at(edge, line[i].at);
    const Vec3 still = line[i].room - goal, along = still + drift;
    const Vec3 way = along.squaredNorm() > still.squaredNorm() ? along : still;
    out[i] = goal + way + drift.norm() * way.normalized();
  }
  return out;
}

MovedEdge moved_edge(const BladeStroke& stroke, std::span<const Vec3> from, std::span<const Vec3> edge,
                     double least_motion) {
  PROSECTOR_ASSERT(from.size() == stroke.edge.size() && least_motion >= 0);
  const std::vector<EdgePoint>& line = stroke.edge;
  MovedEdge out;
  std::vector<std::size_t> bends;  // points at which the moved line may bend; it is straight between them
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Vec3 goal = point_at(edge, line[i].at);
    const bool stays = (goal - from[i]).norm() < least_motion;
    out.to.push_back(stays ? from[i] : goal);
    out.stays.push_back(stays ? 1 : 0);
    if (stays || line[i].is_corner()) bends.push_back(i);
  }
  for (std::size_t b = 0; b + 1 < bends.size(); ++b) {
    const EdgePoint &first = line[bends[b]], &last = line[bends[b + 1]];
    for (std::size_t i = bends[b] + 1; i < bends[b + 1]; ++i)
      out.to[i] = out.to[bends[b]] +
                  (line[i].at - first.at) / (last.at - first.at) * (out.to[bends[b + 1]] - out.to[bends[b]]);
  }
  return out;
}

void hold_edge(BladeStroke& stroke, const MovedEdge& moved, const TetComplex& complex, const TetTree& tree,
               std::span<const Vec3> positions) {
  PROSECTOR_ASSERT(moved.to.size() == stroke.edge.size() && moved.stays.size() == stroke.edge.size());
  PROSECTOR_ASSERT(positions.size() >= complex.node_end());
  std::vector<EdgePoint> line;
  std::vector<TetId> near;
  std::vector<Stretch> way;
  bool from_is_held = false;
  for (std::size_t i = 0; i < stroke.edge.size(); ++i) {
    EdgePoint point = stroke.edge[i];
    const bool stays = moved.stays[i] != 0, is_twin = !line.empty() && line.back().at == point.at;
    if (!stays && (is_twin || !point.is_corner())) continue;
    const bool is_held = stays && complex.has_tet(point.tet);
    if (!is_held) point.tet = TetComplex::none;
    point.room = moved.to[i];
    if (line.empty()) {
      line.push_back(point);
    } else {
      way.clear();
      if (!is_twin && !complex.is_sheet())
        find_stretches(complex, tree, positions, line.back().room, point.room, near, way);
      go_on(line, from_is_held, point, way, complex);
    }
    from_is_held = is_held;
  }
  const auto is_in_tissue = [](const EdgePoint& point) { return point.tet != TetComplex::none; };
  stroke.ended_inside = std::any_of(line.begin(), line.end(), is_in_tissue) &&
                        (stroke.ended_inside || is_in_tissue(line.front()) || is_in_tissue(line.back()));
  stroke.edge = std::move(line);
}

}  // namespace prosector::cutting
