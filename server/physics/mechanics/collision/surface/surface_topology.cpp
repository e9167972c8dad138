#include "server/physics/mechanics/collision/surface/surface_topology.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/assert.h"
#include "common/error.h"

namespace prosector::collision {

namespace {

using Corners = SurfaceTopology::Corners;

std::vector<Corners> checked(std::vector<Corners> triangles, std::size_t vertices) {
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Corners& c = triangles[t];
    if (std::max({c[0], c[1], c[2]}) >= vertices)
      throw InputError(fmt::format(
          "surface: triangle {} refers to vertex {}, but the surface has {} vertices, numbered from 0", t,
          std::max({c[0], c[1], c[2]}), vertices));
    if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0])
      throw InputError(
          fmt::format("surface: triangle {} has a vertex twice; its three vertices must differ", t));
  }
  return triangles;
}

}  // namespace

SurfaceTopology::SurfaceTopology(std::vector<Corners> triangles, std::size_t vertices)
    : triangles_(checked(std::move(triangles), vertices)),
      stars_(triangles_, vertices),
      across_(triangles_.size()),
      open_(triangles_.size()) {
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) find_neighbours(t);
  find_out_whether_closed();
  find_pieces();
}

void SurfaceTopology::follow(const SurfaceEdit& edit) {
  apply(edit, triangles_);
  stars_.follow(edit);
  for (Corners& across : across_)
    for (std::uint32_t& triangle : across) triangle = edit.triangles.now[triangle];
  // The values for added triangles are placeholders: find_neighbours() computes them below.
  apply(edit.triangles, edit.corners, across_);
  apply(edit.triangles, edit.inner, open_);
  for (const std::uint32_t t : stars_.around(edit.touched)) find_neighbours(t);
  find_out_whether_closed();
  pieces_.clear();
  find_pieces();
}

void SurfaceTopology::find_neighbours(std::uint32_t t) {
  PROSECTOR_ASSERT(t < triangles_.size() && across_.size() == triangles_.size() &&
                   open_.size() == triangles_.size());
  open_[t] = 0;
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
    across_[t][k] = sharing == 1 ? other : t;
    if (sharing != 1 || agreeing != 1) open_[t] = 1;
  }
}

void SurfaceTopology::find_out_whether_closed() {
  closed_ = !triangles_.empty() && std::find(open_.begin(), open_.end(), 1) == open_.end();
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

}  // namespace prosector::collision
