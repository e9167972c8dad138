#include "client/view/detail.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "client/view/normals.h"
#include "client/view/triangle_point.h"

namespace prosector {
namespace {

using Vec3f = Eigen::Vector3f;

constexpr std::size_t most_levels = 6;
constexpr std::size_t least_triangles = 64;

/// Returns the squared error at one vertex, as defined by error_of().
float squared_error(const CoarserList::OmittedVertex& out, const std::array<std::uint32_t, 3>& corners,
                    std::span<const Vec3f> positions, std::span<const Vec3f> normals) {
  const auto& [a, b, c] = corners;
  const auto& [s, t] = out.weights;
  const float r = 1 - s - t;
  const Vec3f off = positions[out.vertex] - (r * positions[a] + s * positions[b] + t * positions[c]);
  const Vec3f turned = normals[out.vertex] - (r * normals[a] + s * normals[b] + t * normals[c]);
  return std::max(off.squaredNorm(), out.width * out.width * turned.squaredNorm());
}

/// The surface with its creases closed: coincident vertices are merged.
struct Welded {
  std::vector<std::uint32_t> place;                  // by vertex: its merged vertex
  std::vector<std::vector<std::uint32_t>> vertices;  // by merged vertex: its vertices
  std::vector<Vec3f> positions;
  Triangles triangles;
};

Welded weld(std::span<const Vec3f> rest, const Triangles& triangles) {
  Welded out;
  std::map<std::array<float, 3>, std::uint32_t> known;
  for (std::uint32_t v = 0; v < rest.size(); ++v) {
    const auto [found, is_new] = known.try_emplace({rest[v].x(), rest[v].y(), rest[v].z()},
                                                   static_cast<std::uint32_t>(out.positions.size()));
    if (is_new) {
      out.positions.push_back(rest[v]);
      out.vertices.emplace_back();
    }
    out.place.push_back(found->second);
    out.vertices[found->second].push_back(v);
  }
  for (const auto& [a, b, c] : triangles) out.triangles.push_back({out.place[a], out.place[b], out.place[c]});
  return out;
}

/// Builds coarser lists of a surface, with replacement points for the omitted vertices.
class Coarsening {
 public:
  Coarsening(std::span<const Vec3f> rest, const Triangles& triangles)
      : rest_(rest),
        triangles_(triangles),
        width_(rest.size(), 0.0F),
        welded_(weld(rest, triangles)),
        collapser_(welded_.positions, welded_.triangles) {
    smooth_normals(rest, triangles, normals_);
    for (const auto& t : triangles) {
      const Vec3f twice_area = (rest[t[1]] - rest[t[0]]).cross(rest[t[2]] - rest[t[0]]);
      const float width = std::sqrt(twice_area.norm() / 2) / 2;
      for (const std::uint32_t v : t) width_[v] = std::max(width_[v], width);
    }
  }

  /// Returns a list with at most this number of triangles; nullopt: the surface can't be reduced so far.
  std::optional<CoarserList> reduced_to(std::size_t triangles) {
    if (!collapser_.reduce_to(triangles)) return std::nullopt;
    CoarserList out;
    around_.assign(welded_.positions.size(), {});
    std::vector<bool> used(rest_.size(), false), kept(rest_.size(), false);
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      for (const std::uint32_t v : triangles_[t]) used[v] = true;
      if (collapser_.is_gone(t)) continue;
      std::array<std::uint32_t, 3> corners{};
      for (std::size_t k = 0; k < 3; ++k) {
        corners[k] = replacement_of(triangles_[t][k]);
        kept[corners[k]] = true;
        around_[welded_.place[corners[k]]].push_back(static_cast<std::uint32_t>(out.triangles.size()));
      }
      out.triangles.push_back(corners);
    }
    for (std::uint32_t v = 0; v < rest_.size(); ++v)
      if (used[v] && !kept[v]) out.left_out.push_back(left_out(v, out.triangles));
    return out;
  }

 private:
  /// Returns the vertex that replaces `v`: among the vertices at its merged position, the one with the most
  /// similar normal, so that it is on the same side of creases.
  std::uint32_t replacement_of(std::uint32_t v) const {
    const std::uint32_t place = welded_.place[v], into = collapser_.replacement_of(place);
    if (into == place) return v;
    return *std::ranges::max_element(welded_.vertices[into], {},
                                     [&](std::uint32_t other) { return normals_[v].dot(normals_[other]); });
  }

  /// Finds the replacement point by a local search from the triangles at the vertex's replacement, moving to
  /// better triangles.
  CoarserList::OmittedVertex left_out(std::uint32_t v, const Triangles& triangles) const {
    CoarserList::OmittedVertex best{v, 0, {}, 0};
    float least = std::numeric_limits<float>::infinity();
    std::vector<std::uint32_t> to_try = around_[collapser_.replacement_of(welded_.place[v])];
    while (!to_try.empty()) {
      bool is_better = false;
      for (const std::uint32_t t : to_try) {
        const auto& [a, b, c] = triangles[t];
        const PointOnTriangle place = point_on_triangle_near(rest_[v], rest_[a], rest_[b], rest_[c]);
        const float side =
            std::sqrt(std::min({(rest_[a] - rest_[b]).squaredNorm(), (rest_[b] - rest_[c]).squaredNorm(),
                                (rest_[c] - rest_[a]).squaredNorm()}));
        const CoarserList::OmittedVertex here{v, t, place.weights, std::max(side / 2, width_[v])};
        const float error = squared_error(here, triangles[t], rest_, normals_);
        if (!(error < least)) continue;
        least = error;
        best = here;
        is_better = true;
      }
      to_try.clear();
      if (!is_better) break;
      for (const std::uint32_t corner : triangles[best.triangle]) {
        const auto& more = around_[welded_.place[corner]];
        to_try.insert(to_try.end(), more.begin(), more.end());
      }
    }
    return best;
  }

  std::span<const Vec3f> rest_;
  const Triangles& triangles_;
  std::vector<Vec3f> normals_;
  std::vector<float> width_;  // m: half the width of the largest triangle at each vertex
  Welded welded_;
  EdgeCollapser collapser_;
  // By merged vertex: triangles of the list under construction.
  std::vector<std::vector<std::uint32_t>> around_;
};

}  // namespace

Detail make_detail(std::span<const Vec3f> rest, const Triangles& triangles) {
  Detail out;
  if (triangles.size() < min_detail_triangles) return out;
  Coarsening coarsening(rest, triangles);
  for (std::size_t wanted = triangles.size() / 2;
       wanted >= least_triangles && out.coarser.size() < most_levels; wanted /= 2) {
    auto list = coarsening.reduced_to(wanted);
    if (!list) break;
    out.coarser.push_back(std::move(*list));
  }
  return out;
}

double error_of(const CoarserList& list, std::span<const Vec3f> positions, std::span<const Vec3f> normals,
                double enough) {
  const auto most = static_cast<float>(enough * enough);
  float largest = 0;
  for (const CoarserList::OmittedVertex& out : list.left_out) {
    largest = std::max(largest, squared_error(out, list.triangles[out.triangle], positions, normals));
    if (largest > most) break;
  }
  return std::sqrt(static_cast<double>(largest));
}

}  // namespace prosector
