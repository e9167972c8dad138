#include "server/physics/mechanics/cutting/edge_splitter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>

#include "common/assert.h"
#include "server/physics/mechanics/cutting/tet_shape.h"

namespace prosector::cutting {
namespace {

// Relative to a node's shortest edge: a node closer to the blade counts as lying on the blade.
constexpr double near_share = 0.1;
// Relative to the cell size: a node of a cut's wall this close to the blade counts as lying on the blade.
// So a repeated cut shaves off no thin slice.
constexpr double wall_share = 0.15;
constexpr double one_sheet = 0.7;  // cosine of the angle up to which two planes belong to one smooth surface

double degrees_of(double cosine) {
  return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi;
}

struct CrossedEdge {
  double length = 0;  // m, in the rest shape
  NodeId a = 0, b = 0;
  SweptSurface::Crossing at;
  bool operator<(const CrossedEdge& o) const {  // the longest edge comes first, then the lowest ids
    if (length != o.length) return length < o.length;
    return a != o.a ? a > o.a : b > o.b;
  }
};

class EdgeSplitter {
 public:
  EdgeSplitter(TetComplex& complex, const SweptSurface& sheet, std::vector<Vec3>& x, Marks& marks,
               CutResult& result)
      : complex_(complex), sheet_(sheet), x_(x), marks_(marks), result_(result) {}

  void run(std::span<const TetId> candidates) {
    std::vector<std::uint64_t> edges;  // lower node id in the high 32 bits
    edges.reserve(6 * candidates.size());
    for (const TetId t : candidates) {
      const auto& c = complex_.corners(t);
      for (std::size_t i = 0; i < c.size(); ++i)
        for (std::size_t j = i + 1; j < c.size(); ++j)
          edges.push_back(std::uint64_t{std::min(c[i], c[j])} << 32 | std::max(c[i], c[j]));
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    mark_near(edges);
    for (const std::uint64_t edge : edges) push(lower_end(edge), higher_end(edge));
    while (!crossed_.empty()) {
      const CrossedEdge e = crossed_.top();
      crossed_.pop();
      complex_.tables().around_edge(e.a, e.b, around_);
      if (around_.empty() || is_resolved(e)) continue;
      if (!split(e)) snap(e);
    }
  }

 private:
  static NodeId lower_end(std::uint64_t edge) { return static_cast<NodeId>(edge >> 32); }
  static NodeId higher_end(std::uint64_t edge) { return static_cast<NodeId>(edge); }

  void mark_near(std::span<const std::uint64_t> edges) {
    constexpr double never = std::numeric_limits<double>::infinity();
    std::vector<double> shortest(x_.size(), never);
    for (const std::uint64_t edge : edges) {
      const NodeId a = lower_end(edge), b = higher_end(edge);
      const double length = (x_[b] - x_[a]).norm();
      shortest[a] = std::min(shortest[a], length);
      shortest[b] = std::min(shortest[b], length);
    }
    for (NodeId node = 0; node < shortest.size(); ++node) {
      if (shortest[node] == never || marks_.find(node)) continue;
      const double reach = near_share * shortest[node];
      auto foot = sheet_.foot(x_[node], std::max(reach, wall_share * complex_.tables().cell));
      if (foot && foot->distance > reach && !is_on_wall(node)) foot.reset();
      if (foot) mark(node, complex_.star(node).front(), foot->point, foot->normal);
    }
  }

  bool is_on_wall(NodeId node) const {
    for (const TetId t : complex_.star(node))
      for (std::size_t k = 0; k < complex_.sides(); ++k)
        if (complex_.is_wall(t, k) && complex_.corners(t)[k] != node) return true;
    return false;
  }

  /// Marks a node. `point` and `normal` are those of the swept surface in the current configuration. They are
  /// stored pulled back to the rest shape, which is exact for the linear map of a tetrahedron. For a sheet,
  /// the mark's normal is projected into the sheet.
  void mark(NodeId node, TetId tet, const Vec3& point, const Vec3& normal) {
    PROSECTOR_ASSERT(complex_.has_tet(tet) && complex_.has_node(node) && node < x_.size());
    Vec3 covector = gradient(tet).transpose() * normal;
    if (complex_.is_sheet()) covector = in_sheet(covector, complex_.star(node));
    BladeStroke::Mark m{node, complex_.rest(node), normal};
    const double length = covector.norm();
    if (length > 1e-9) {
      m.normal = covector / length;
      m.point -= m.normal * (normal.dot(x_[node] - point) / length);
    }
    result_.farthest_snap = std::max(result_.farthest_snap, (m.point - complex_.rest(node)).norm());
    marks_.add(m);
  }

  /// Returns the deformation gradient of an element; for a triangle, it maps the unit normal to the unit
  /// normal.
  Mat3 gradient(TetId tet) const {
    const auto& c = complex_.corners(tet);
    Mat3 rest, now;
    for (std::size_t k = 0; k + 1 < c.size(); ++k) {
      const NodeId corner = c[k + 1];
      rest.col(static_cast<Eigen::Index>(k)) = complex_.rest(corner) - complex_.rest(c[0]);
      now.col(static_cast<Eigen::Index>(k)) = x_[corner] - x_[c[0]];
    }
    if (complex_.is_sheet()) {
      rest.col(2) = rest.col(0).cross(rest.col(1)).normalized();
      now.col(2) = now.col(0).cross(now.col(1)).normalized();
    }
    return now * rest.inverse();
  }

  /// Returns the component of a rest-shape normal that lies in the plane of these triangles. Without this
  /// projection, an inclined or twisted blade would put bent parts of the sheet on the wrong side.
  Vec3 in_sheet(const Vec3& normal, std::span<const TetId> triangles) const {
    PROSECTOR_ASSERT(!triangles.empty());
    Vec3 area = Vec3::Zero();
    for (const TetId t : triangles) {
      const auto c = complex_.corners(t);
      area += (complex_.rest(c[1]) - complex_.rest(c[0])).cross(complex_.rest(c[2]) - complex_.rest(c[0]));
    }
    const Vec3 up = area.normalized();
    return normal - up * up.dot(normal);
  }

  void push(NodeId a, NodeId b) {
    const auto crossing = sheet_.crossing(x_[a], x_[b]);
    if (!crossing) return;
    const double length = (complex_.rest(b) - complex_.rest(a)).norm();
    crossed_.push({length, a, b, *crossing});
  }

  // A crossing is resolved if an end of the edge already lies on the same smooth swept surface.
  bool is_resolved(const CrossedEdge& e) const {
    const auto met_at = [&](NodeId end, double t) {
      const BladeStroke::Mark* mark = marks_.find(end);
      if (!mark) return false;
      if (t <= near_share) return true;
      Vec3 normal = gradient(around_.front()).transpose() * e.at.normal;
      if (complex_.is_sheet()) normal = in_sheet(normal, around_);
      return std::abs(normal.dot(mark->normal)) >= one_sheet * normal.norm();
    };
    return met_at(e.a, e.at.t) || met_at(e.b, 1 - e.at.t);
  }

  double cos_least(const std::array<Vec3, 4>& x) const {
    return complex_.is_sheet() ? cos_least_angle(x[0], x[1], x[2]) : cos_least_dihedral(x);
  }

  // Returns whether a split at t respects the minimum angle and the minimum edge length. `worst`: cosine of
  // the smallest angle in the halves.
  bool may_split(const CrossedEdge& e, double t, double& worst) const {
    static const double floor = std::cos(least_dihedral_deg * std::numbers::pi / 180);
    const double least = least_edge_share * complex_.tables().cell;
    if (std::min(t, 1 - t) * e.length < least) return false;
    const Vec3 middle = complex_.rest(e.a) + (complex_.rest(e.b) - complex_.rest(e.a)) * t;
    worst = -1;
    for (const TetId tet : around_) {
      std::array<Vec3, 4> whole;
      for (std::size_t k = 0; k < complex_.sides(); ++k) {
        const NodeId corner = complex_.corners(tet)[k];
        whole[k] = complex_.rest(corner);
        if (corner != e.a && corner != e.b && (whole[k] - middle).norm() < least) return false;
      }
      double allowed = -1;  // cosine before the split, computed when needed
      for (const NodeId end : {e.a, e.b}) {
        std::array<Vec3, 4> half = whole;
        half[complex_.corner_index(tet, end)] = middle;
        const double cosine = cos_least(half);
        worst = std::max(worst, cosine);
        if (cosine <= floor) continue;
        if (allowed < 0) allowed = cos_least(whole);
        if (cosine > allowed) return false;
      }
    }
    return true;
  }

  bool split(const CrossedEdge& e) {
    PROSECTOR_ASSERT(x_.size() == complex_.node_end() && !around_.empty());
    double worst = -1;
    const double exact = e.at.t, nearest = std::min(exact, 1 - exact);
    for (const double t : {exact, std::clamp(exact, 0.25, 0.75), 0.5}) {
      if (t != exact && std::abs(t - exact) >= nearest) continue;  // an end is nearer than t
      if (!may_split(e, t, worst)) continue;
      const auto node = static_cast<NodeId>(complex_.node_end());
      SplitEdge op{e.a,
                   e.b,
                   node,
                   t,
                   static_cast<TetId>(complex_.tet_end()),
                   static_cast<std::uint32_t>(around_.size())};
      complex_.apply(op);
      x_.push_back(x_[e.a] + (x_[e.b] - x_[e.a]) * t);
      note(op, worst);
      result_.ops.emplace_back(op);
      mark(node, op.first, x_[e.a] + (x_[e.b] - x_[e.a]) * exact, e.at.normal);
      if (t != exact) ++result_.snapped;
      push_edges_of(node);
      return true;
    }
    return false;
  }

  void note(const SplitEdge& op, double worst) {
    ++result_.split_edges;
    result_.split_tets += op.count;
    const double angle = degrees_of(worst);
    result_.least_dihedral_deg = std::min(result_.least_dihedral_deg, angle);
    if (angle < least_dihedral_deg - 1e-9) ++result_.slivers;
  }

  void push_edges_of(NodeId node) {
    ends_.clear();
    for (const TetId t : complex_.star(node))
      for (const NodeId corner : complex_.corners(t))
        if (corner != node) ends_.push_back(corner);
    std::sort(ends_.begin(), ends_.end());
    ends_.erase(std::unique(ends_.begin(), ends_.end()), ends_.end());
    for (const NodeId end : ends_) push(end, node);
  }

  void snap(const CrossedEdge& e) {
    const bool at_a = !marks_.find(e.a) && (e.at.t <= 0.5 || marks_.find(e.b));
    const NodeId node = at_a ? e.a : e.b;
    if (marks_.find(node)) return;  // both ends have marks from another part of the stroke; these suffice
    ++result_.snapped;
    mark(node, around_.front(), x_[e.a] + (x_[e.b] - x_[e.a]) * e.at.t, e.at.normal);
  }

  TetComplex& complex_;
  const SweptSurface& sheet_;
  std::vector<Vec3>& x_;
  Marks& marks_;
  CutResult& result_;
  std::priority_queue<CrossedEdge> crossed_;
  std::vector<TetId> around_;
  std::vector<NodeId> ends_;
};

}  // namespace

Marks::Marks(const std::vector<Mark>& known, std::size_t nodes)
    : marks_(known), index_(nodes, none), known_(known.size()) {
  for (std::uint32_t i = 0; i < marks_.size(); ++i)
    if (marks_[i].node < nodes) index_[marks_[i].node] = i;
}

void Marks::add(const Mark& mark) {
  PROSECTOR_ASSERT(mark.node >= index_.size() || index_[mark.node] == none);
  if (mark.node >= index_.size()) index_.resize(mark.node + 1u, none);
  index_[mark.node] = static_cast<std::uint32_t>(marks_.size());
  marks_.push_back(mark);
}

std::vector<BladeStroke::Mark> Marks::by_node() const {
  std::vector<Mark> out = marks_;
  std::sort(out.begin(), out.end(), [](const Mark& a, const Mark& b) { return a.node < b.node; });
  return out;
}

void split_edges(TetComplex& complex, const SweptSurface& sheet, std::span<const TetId> candidates,
                 std::vector<Vec3>& x, Marks& marks, CutResult& result) {
  PROSECTOR_ASSERT(is_ascending(candidates) && x.size() >= complex.node_end());
  EdgeSplitter(complex, sheet, x, marks, result).run(candidates);
}

}  // namespace prosector::cutting
