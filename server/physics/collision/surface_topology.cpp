#include "server/physics/collision/surface_topology.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "common/error.h"

namespace prosector {

SurfaceTopology::SurfaceTopology(std::vector<Corners> triangles, std::size_t vertices)
    : triangles_(std::move(triangles)), around_begin_(vertices + 1, 0) {
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    const Corners& c = triangles_[t];
    if (std::max({c[0], c[1], c[2]}) >= vertices)
      throw InputError(fmt::format("surface: triangle {} names vertex {}, there are {}", t,
                                   std::max({c[0], c[1], c[2]}), vertices));
    if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0])
      throw InputError(fmt::format("surface: triangle {} has a vertex twice; its three must differ", t));
    for (const std::uint32_t v : c) ++around_begin_[v + 1];
  }
  std::partial_sum(around_begin_.begin(), around_begin_.end(), around_begin_.begin());
  around_.resize(3 * triangles_.size());
  std::vector<std::uint32_t> next(around_begin_.begin(), around_begin_.end() - 1);
  for (std::uint32_t t = 0; t < triangles_.size(); ++t)
    for (const std::uint32_t v : triangles_[t]) around_[next[v]++] = t;
  find_neighbours();
  find_pieces();
}

void SurfaceTopology::find_neighbours() {
  across_.resize(triangles_.size());
  for (std::uint32_t t = 0; t < triangles_.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = triangles_[t][k], to = triangles_[t][(k + 1) % 3];
      std::uint32_t other = t;
      int agreeing = 0, sharing = 0;
      for (const std::uint32_t u : around(from)) {
        if (u == t) continue;
        for (std::size_t j = 0; j < 3; ++j) {
          const std::uint32_t p = triangles_[u][j], q = triangles_[u][(j + 1) % 3];
          if ((p == to && q == from) || (p == from && q == to)) {
            ++sharing;
            agreeing += p == to ? 1 : 0;
            other = u;
          }
        }
      }
      const bool good = sharing == 1 && agreeing == 1;
      across_[t][k] = sharing == 1 ? other : t;
      closed_ = closed_ && good;
    }
  closed_ = closed_ && !triangles_.empty();
}

void SurfaceTopology::find_pieces() {
  std::vector<char> seen(vertices(), 0);
  std::vector<std::uint32_t> open;
  for (std::uint32_t v = 0; v < vertices(); ++v) {
    if (seen[v] || around(v).empty()) continue;
    pieces_.push_back(v);
    seen[v] = 1;
    open.push_back(v);
    while (!open.empty()) {
      const std::uint32_t at = open.back();
      open.pop_back();
      for (const std::uint32_t t : around(at))
        for (const std::uint32_t next : triangles_[t])
          if (!seen[next]) {
            seen[next] = 1;
            open.push_back(next);
          }
    }
  }
}

}  // namespace prosector
