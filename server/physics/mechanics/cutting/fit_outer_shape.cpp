// Fit of the outer shape to the finer surface of the uncut body.

#include <algorithm>
#include <cmath>
#include <optional>

#include "common/assert.h"
#include "server/physics/base/parallel.h"
#include "server/physics/mechanics/collision/surface/surface_tree.h"
#include "server/physics/mechanics/cutting/outer_shape.h"

namespace prosector::cutting {
namespace {

constexpr double farthest = 0.75;  // longest offset from the boundary, relative to the edge length
// Ratio of an edge's length to the surface's mean edge length above which even small midpoint offsets are
// drawn.
constexpr double finer = 1.4;
constexpr double near_enough = 25e-6;  // m: smaller offsets are ignored
// Smallest cosine of the angle between the normals of a drawn triangle and of its boundary face.
constexpr double least_cosine = 0.3;
// Tolerance of barycentric coordinates, so that a ray through an edge hits a triangle.
constexpr double beside = 1e-9;
// Smallest shape measure of a drawn triangle: twice its area over its longest edge squared.
constexpr double least_shape = 0.2;
constexpr double drawn_in = 0.75;  // factor by which offsets of bad triangles are reduced in each round
constexpr int rounds = 16;         // after these rounds, offsets of triangles that are still bad become zero
constexpr std::size_t rays_per_chunk = 256;

/// Returns the parameter s at which the line x + s·direction crosses the triangle, |s| ≤ 1 (Möller and
/// Trumbore 1997). Accepts only triangles whose outside faces along `direction`.
std::optional<double> hit(const Vec3& x, const Vec3& direction, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, p = direction.cross(ac);
  const double det = ab.dot(p);
  if (!(det < 0)) return std::nullopt;  // the triangle's outside faces against the direction
  const Vec3 from = x - a, q = from.cross(ab);
  const double u = from.dot(p) / det, v = direction.dot(q) / det, s = ac.dot(q) / det;
  if (u < -beside || v < -beside || u + v > 1 + beside || !(std::abs(s) <= 1)) return std::nullopt;
  return s;
}

/// Returns the shape measure: twice the area over the longest edge squared.
double shape(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return (b - a).cross(c - a).norm() / longest;
}

double mean_edge(const TriangleMesh& mesh) {
  PROSECTOR_ASSERT(!mesh.triangles.empty());
  double sum = 0;
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) sum += (mesh.positions[t[(i + 1) % 3]] - mesh.positions[t[i]]).norm();
  return sum / (3 * static_cast<double>(mesh.triangles.size()));
}

}  // namespace

/// Computes the offsets of an OuterShape.
class OuterShape::Fit {
 public:
  Fit(const TetComplex& complex, const TriangleMesh& surface)
      : complex_(complex), surface_(surface), tree_(surface.triangles, surface.positions) {}

  void find(OuterShape& out) {
    find_boundary(out);
    PROSECTOR_ASSERT(out.edges_.size() == edge_.size() &&
                     reach_.size() == complex_.node_end() + edge_.size());
    const std::size_t nodes = complex_.node_end();
    to_surface_.assign(nodes + edge_.size(), Vec3::Zero());
    parallel_chunks(to_surface_.size(), rays_per_chunk,
                    [&](std::size_t first, std::size_t last, std::size_t) {
                      for (std::size_t i = first; i < last; ++i)
                        if (reach_[i] > 0) to_surface_[i] = offset_at(place_[i], normal_[i], reach_[i]);
                    });
    for (std::size_t i = 0; i < nodes; ++i)
      if (to_surface_[i].norm() <= near_enough) to_surface_[i].setZero();
    for (std::size_t i = 0; i < edge_.size(); ++i)  // midpoints without a surface nearby
      if (to_surface_[nodes + i].isZero(0))
        to_surface_[nodes + i] = (to_surface_[edge_[i].low] + to_surface_[edge_[i].high]) / 2;
    draw_in();
    bool any = std::any_of(to_surface_.begin(), to_surface_.begin() + static_cast<std::ptrdiff_t>(nodes),
                           [](const Vec3& offset) { return !offset.isZero(0); });
    out.offset_.assign(to_surface_.begin(), to_surface_.begin() + static_cast<std::ptrdiff_t>(nodes));
    const double fine = mean_edge(surface_);
    for (std::size_t i = 0; i < edge_.size(); ++i) {
      Edge& edge = out.edges_[i];
      edge.sag = to_surface_[nodes + i] - (to_surface_[edge_[i].low] + to_surface_[edge_[i].high]) / 2;
      const double length = reach_[nodes + i] / farthest;
      edge.middle = edge.sag.norm() > (length > finer * fine ? near_enough : chord_error);
      if (!edge.middle) edge.sag.setZero();
      any |= edge.middle;
    }
    if (!any) out = {};
  }

 private:
  struct Side {
    NodeId low, high, beyond;
    std::uint32_t face, corner;  // from this corner to the next one of the face
  };
  struct Face {
    std::array<NodeId, 3> node;
    std::array<std::uint32_t, 3> edge;  // from each corner to the next one
  };

  void find_boundary(OuterShape& out) {
    std::vector<Side> sides;
    for (const TetId t : tet_ids(complex_))
      for (std::size_t k = 0; k < 4; ++k) {
        if (complex_.neighbor(t, k) != TetComplex::none) continue;
        Face face{};
        for (std::size_t i = 0; i < 3; ++i) face.node[i] = complex_.corners(t)[TetComplex::face[k][i]];
        for (std::uint32_t i = 0; i < 3; ++i) {
          const auto [low, high] = std::minmax(face.node[i], face.node[(i + 1) % 3]);
          sides.push_back({low, high, face.node[(i + 2) % 3], static_cast<std::uint32_t>(face_.size()), i});
        }
        face_.push_back(face);
      }
    std::stable_sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
      return std::pair(a.low, a.high) < std::pair(b.low, b.high);
    });
    const std::size_t nodes = complex_.node_end();
    out.begin_.assign(nodes + 1, 0);
    out.outer_.assign(nodes, 0);
    for (const Side& side : sides) {
      if (edge_.empty() || edge_.back().low != side.low || edge_.back().high != side.high) {
        edge_.push_back(side);
        out.edges_.push_back({side.high, {side.beyond, side.beyond}, Vec3::Zero(), false});
        ++out.begin_[side.low + 1u];
      }
      out.edges_.back().beyond[1] = side.beyond;
      face_[side.face].edge[side.corner] = static_cast<std::uint32_t>(edge_.size() - 1);
      out.outer_[side.low] = out.outer_[side.high] = 1;
    }
    for (std::size_t i = 0; i < nodes; ++i) out.begin_[i + 1] += out.begin_[i];
    find_rays();
  }

  /// Finds the rays. The direction at a node is the area-weighted mean normal of its faces; at an edge
  /// midpoint, of the edge's two faces.
  void find_rays() {
    const std::size_t nodes = complex_.node_end();
    place_.resize(nodes + edge_.size());
    normal_.assign(place_.size(), Vec3::Zero());
    reach_.assign(place_.size(), 0.0);
    for (const Face& face : face_) {
      const Vec3 &a = complex_.rest(face.node[0]), &b = complex_.rest(face.node[1]),
                 &c = complex_.rest(face.node[2]);
      const Vec3 normal = (b - a).cross(c - a);
      for (std::size_t i = 0; i < 3; ++i) {
        normal_[face.node[i]] += normal;
        normal_[nodes + face.edge[i]] += normal;
      }
    }
    for (Vec3& normal : normal_) normal.normalize();  // zero for inner nodes and where the normals cancel
    std::vector<int> ends(nodes, 0);
    for (std::size_t i = 0; i < edge_.size(); ++i) {
      const auto [low, high] = std::array{edge_[i].low, edge_[i].high};
      const double length = (complex_.rest(high) - complex_.rest(low)).norm();
      place_[nodes + i] = (complex_.rest(low) + complex_.rest(high)) / 2;
      reach_[nodes + i] = farthest * length;
      for (const NodeId end : {low, high}) {
        place_[end] = complex_.rest(end);
        reach_[end] += farthest * length;
        ++ends[end];
      }
    }
    for (std::size_t i = 0; i < nodes; ++i)
      if (ends[i] > 0) reach_[i] /= ends[i];
  }

  /// Returns the offset to the nearest surface point on the ray; zero if the ray meets no surface.
  Vec3 offset_at(const Vec3& x, const Vec3& normal, double reach) const {
    const Vec3 direction = reach * normal;
    collision::Aabb box;
    box.add(x - direction);
    box.add(x + direction);
    double nearest = 2;
    tree_.visit([&](const collision::Aabb& other) { return box.overlaps(other); },
                [&](const collision::SurfaceTree::Node& leaf) {
                  for (std::uint32_t k = leaf.begin; k < leaf.end; ++k) {
                    const auto& t = surface_.triangles[tree_.order()[k]];
                    const auto s = hit(x, direction, surface_.positions[t[0]], surface_.positions[t[1]],
                                       surface_.positions[t[2]]);
                    if (s && std::abs(*s) < std::abs(nearest)) nearest = *s;
                  }
                });
    return nearest > 1 ? Vec3::Zero() : Vec3(nearest * direction);
  }

  /// Reduces offsets until no drawn triangle is inverted, nearly inverted or a needle.
  void draw_in() {
    std::vector<std::uint8_t> bad(to_surface_.size());
    for (int round = 0;; ++round) {
      std::fill(bad.begin(), bad.end(), std::uint8_t{0});
      bool any = false;
      for (const Face& face : face_) {
        if (is_good(face)) continue;
        any = true;
        for (std::size_t i = 0; i < 3; ++i) bad[face.node[i]] = bad[complex_.node_end() + face.edge[i]] = 1;
      }
      if (!any) return;
      for (std::size_t i = 0; i < bad.size(); ++i)
        if (bad[i] != 0) to_surface_[i] *= round < rounds ? drawn_in : 0;
    }
  }

  bool is_good(const Face& face) const {
    std::array<Vec3, 3> corner, middle, drawn, drawn_middle;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t m = complex_.node_end() + face.edge[i];
      corner[i] = place_[face.node[i]];
      drawn[i] = corner[i] + to_surface_[face.node[i]];
      middle[i] = place_[m];
      drawn_middle[i] = middle[i] + to_surface_[m];
    }
    const Vec3 whole = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
    const double flat = std::min(least_shape, shape(corner[0], corner[1], corner[2]) / 2);
    const auto good = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
      const Vec3 normal = (b - a).cross(c - a);
      return normal.dot(whole) >= least_cosine * normal.norm() * whole.norm() && shape(a, b, c) >= flat;
    };
    bool all = good(drawn[0], drawn[1], drawn[2]) && good(drawn_middle[0], drawn_middle[1], drawn_middle[2]);
    for (std::size_t i = 0; i < 3; ++i)
      all = all && good(drawn_middle[(i + 2) % 3], drawn[i], drawn_middle[i]);
    return all;
  }

  const TetComplex& complex_;
  const TriangleMesh& surface_;
  collision::SurfaceTree tree_;
  std::vector<Face> face_;
  std::vector<Side> edge_;  // one side of each edge; ascending
  // Rays of nodes, then of edge midpoints. place_: origin in the rest shape, m. normal_: direction. reach_:
  // length, m, 0 for inner nodes. to_surface_: the resulting offset, m.
  std::vector<Vec3> place_, normal_;
  std::vector<double> reach_;
  std::vector<Vec3> to_surface_;
};

OuterShape::OuterShape(const TetComplex& uncut, const TriangleMesh& surface) {
  if (uncut.is_sheet() || surface.triangles.empty()) return;
  Fit(uncut, surface).find(*this);
}

}  // namespace prosector::cutting
