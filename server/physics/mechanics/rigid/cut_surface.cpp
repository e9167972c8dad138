#include "server/physics/mechanics/rigid/cut_surface.h"

#include <algorithm>
#include <map>
#include <utility>

#include "common/error.h"
#include "server/physics/mechanics/rigid/triangulate.h"

namespace prosector::rigid {
namespace {

constexpr double on_plane = 1e-9;  // m

using VertexTriple = std::array<std::uint32_t, 3>;

/// Merges vertices with equal positions.
TriangleMesh welded(const TriangleMesh& mesh) {
  TriangleMesh out;
  std::map<std::array<double, 3>, std::uint32_t> at;
  std::vector<std::uint32_t> to;
  for (const Vec3& x : mesh.positions) {
    const auto [it, fresh] =
        at.emplace(std::array{x.x(), x.y(), x.z()}, static_cast<std::uint32_t>(out.positions.size()));
    if (fresh) out.positions.push_back(x);
    to.push_back(it->second);
  }
  for (const VertexTriple& t : mesh.triangles) {
    const VertexTriple w = {to[t[0]], to[t[1]], to[t[2]]};
    if (w[0] != w[1] && w[1] != w[2] && w[2] != w[0]) out.triangles.push_back(w);
  }
  return out;
}

/// Returns the mesh without unused vertices.
TriangleMesh compacted(const std::vector<Vec3>& positions, const std::vector<VertexTriple>& triangles) {
  TriangleMesh out;
  std::map<std::uint32_t, std::uint32_t> at;
  for (VertexTriple t : triangles) {
    for (std::uint32_t& corner : t) {
      const auto [it, fresh] = at.emplace(corner, static_cast<std::uint32_t>(out.positions.size()));
      if (fresh) out.positions.push_back(positions[corner]);
      corner = it->second;
    }
    out.triangles.push_back(t);
  }
  return out;
}

class Cutter {
 public:
  Cutter(TriangleMesh mesh, const Vec3& point, const Vec3& normal)
      : positions_(std::move(mesh.positions)), point_(point), normal_(normal.normalized()) {
    for (const Vec3& x : positions_) {
      const double s = normal_.dot(x - point_);
      height_.push_back(std::abs(s) < on_plane ? on_plane : s);
    }
    for (const VertexTriple& t : mesh.triangles) split(t);
    close();
  }
  CutSurface result() const { return {compacted(positions_, above_), compacted(positions_, below_)}; }

 private:
  std::vector<Vec3> positions_;
  std::vector<double> height_;  // m, above the plane, of the mesh's original vertices
  Vec3 point_, normal_;
  std::vector<VertexTriple> above_, below_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> crossings_;  // from edge to its new vertex
  std::map<std::uint32_t, std::uint32_t> rim_;  // boundary of the upper part: from vertex to vertex

  std::uint32_t crossing(std::uint32_t a, std::uint32_t b) {
    const auto [it, fresh] =
        crossings_.emplace(std::minmax(a, b), static_cast<std::uint32_t>(positions_.size()));
    if (fresh) {
      const auto [lo, hi] = std::minmax(a, b);
      const double share = height_[lo] / (height_[lo] - height_[hi]);
      positions_.push_back(positions_[lo] + share * (positions_[hi] - positions_[lo]));
    }
    return it->second;
  }

  void split(VertexTriple t) {
    const auto above = [&](std::uint32_t v) { return height_[v] > 0; };
    const auto count = std::count_if(t.begin(), t.end(), above);
    if (count == 0 || count == 3) {
      (count == 3 ? above_ : below_).push_back(t);
      return;
    }
    while (above(t[0]) != (count == 1) || above(t[1]) == (count == 1) || above(t[2]) == (count == 1))
      std::rotate(t.begin(), t.begin() + 1, t.end());  // now t[0] is alone on its side
    const std::uint32_t first = crossing(t[0], t[1]), second = crossing(t[0], t[2]);
    auto& alone = count == 1 ? above_ : below_;
    auto& others = count == 1 ? below_ : above_;
    alone.push_back({t[0], first, second});
    others.push_back({first, t[1], t[2]});
    others.push_back({first, t[2], second});
    const auto [from, to] = count == 1 ? std::pair(first, second) : std::pair(second, first);
    if (!rim_.emplace(from, to).second)
      throw InputError(
          "the body's surface is not closed where the fracture plane cuts it; close the mesh there or move "
          "the plane");
  }

  void close() {
    std::vector<std::vector<std::uint32_t>> loops;
    while (!rim_.empty()) {
      std::vector<std::uint32_t>& loop = loops.emplace_back();
      for (auto it = rim_.begin(); it != rim_.end(); it = rim_.find(loop.back())) {
        if (loop.empty()) loop.push_back(it->first);
        const std::uint32_t to = it->second;
        rim_.erase(it);
        if (to == loop.front()) break;
        loop.push_back(to);
        if (!rim_.contains(to))
          throw InputError(
              "the body's surface is not closed where the fracture plane cuts it; close the mesh there or "
              "move the plane");
      }
    }
    // Viewed against the normal, the lower part lies inside its loops.
    const Vec3 u = normal_.unitOrthogonal(), v = normal_.cross(u);
    std::vector<Vec2> flat;
    for (const Vec3& x : positions_) flat.emplace_back(u.dot(x - point_), v.dot(x - point_));
    for (const VertexTriple& t : triangulate(flat, loops)) {
      below_.push_back(t);
      above_.push_back({t[0], t[2], t[1]});
    }
  }
};

}  // namespace

CutSurface cut_surface(const TriangleMesh& mesh, const Vec3& point, const Vec3& normal) {
  return Cutter(welded(mesh), point, normal).result();
}

}  // namespace prosector::rigid
