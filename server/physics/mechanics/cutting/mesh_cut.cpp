#include "server/physics/mechanics/cutting/mesh_cut.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "common/assert.h"
#include "common/error.h"
#include "server/physics/mechanics/cutting/cut_through.h"
#include "server/physics/mechanics/cutting/edge_splitter.h"
#include "server/physics/mechanics/cutting/missing_nodes.h"
#include "server/physics/mechanics/cutting/sheet_passage.h"
#include "server/physics/mechanics/cutting/swept_surface.h"

namespace prosector::cutting {
namespace {

// m: a point of the edge that moved less stays where it is until it has moved that far. The direction of
// smaller motions is noise, and so would be the normal of the swept surface.
constexpr double least_motion = 1e-4;
// Cosine: a line that leaves the body in a direction this close to its last cutting motion has gone on;
// otherwise it was drawn back.
constexpr double same_way = 0.5;

bool all_marked(const TetComplex& complex, const Marks& marks, TetId tet) {
  const auto& c = complex.corners(tet);
  return std::all_of(c.begin(), c.end(), [&](NodeId corner) { return marks.find(corner) != nullptr; });
}

/// Returns the summed height of `x` (rest shape) above the planes marked at the tetrahedron's corners;
/// `reference` points up.
double height(const TetComplex& complex, const Marks& marks, TetId tet, const Vec3& x,
              const Vec3& reference) {
  double sum = 0;
  for (const NodeId corner : complex.corners(tet)) {
    const BladeStroke::Mark* mark = marks.find(corner);
    if (!mark) continue;
    const double h = mark->normal.dot(x - mark->point);
    sum += mark->normal.dot(reference) < 0 ? -h : h;
  }
  return sum;
}

/// Returns whether a tetrahedron with at most one unmarked corner lies above the cut. The unmarked corner
/// decides. If all corners are marked, the neighbours decide, so that no small fragment is left; if they
/// disagree, the centroid decides.
bool is_above(const TetComplex& complex, const Marks& marks, TetId tet, const Vec3& reference) {
  const auto by_corner = [&](TetId t) {
    Vec3 x = Vec3::Zero();
    for (const NodeId corner : complex.corners(t))
      if (!marks.find(corner)) x = complex.rest(corner);
    return height(complex, marks, t, x, reference) > 0;
  };
  if (!all_marked(complex, marks, tet)) return by_corner(tet);
  bool above = false, below = false;
  for (std::size_t k = 0; k < complex.sides(); ++k) {
    const TetId beyond = complex.neighbor(tet, k);
    if (beyond == TetComplex::none || all_marked(complex, marks, beyond)) continue;
    (by_corner(beyond) ? above : below) = true;
  }
  if (above != below) return above;
  Vec3 middle = Vec3::Zero();
  for (const NodeId corner : complex.corners(tet))
    middle += complex.rest(corner) / static_cast<double>(complex.sides());
  return height(complex, marks, tet, middle, reference) > 0;
}

SlitFaces faces_to_slit(const TetComplex& complex, const Marks& marks) {
  std::vector<std::uint8_t> is_touched(complex.tet_end(), 0);
  std::vector<TetId> touched;
  for (const auto& mark : marks.added())
    for (const TetId t : complex.star(mark.node))
      if (!std::exchange(is_touched[t], std::uint8_t{1})) touched.push_back(t);
  std::sort(touched.begin(), touched.end());
  SlitFaces op;
  for (const TetId t : touched) {
    const auto c = complex.corners(t);
    std::array<const BladeStroke::Mark*, 4> mark{};
    std::size_t marked = 0;
    for (std::size_t k = 0; k < c.size(); ++k)
      if ((mark[k] = marks.find(c[k]))) ++marked;
    if (marked + 1 < c.size()) continue;
    for (std::size_t k = 0; k < c.size(); ++k) {
      const TetId beyond = complex.neighbor(t, k);
      if (marked < c.size() && mark[k]) continue;  // the face has an unmarked corner
      if (beyond == TetComplex::none || (beyond < t && is_touched[beyond])) continue;
      const BladeStroke::Mark* first = nullptr;
      for (const std::size_t j : TetComplex::face[k])
        if (j < c.size() && (!first || mark[j]->node < first->node)) first = mark[j];
      PROSECTOR_ASSERT(first != nullptr);
      const Vec3& up = first->normal;
      if (is_above(complex, marks, t, up) != is_above(complex, marks, beyond, up))
        op.faces.push_back({std::min(t, beyond), std::max(t, beyond)});
    }
  }
  std::sort(op.faces.begin(), op.faces.end());
  return op;
}

/// Returns the tetrahedra connected with `first` after `slit` is applied; none if their volume exceeds the
/// minimum piece.
std::vector<TetId> fragment_at(const TetComplex& complex, const SlitFaces& slit, TetId first) {
  PROSECTOR_ASSERT(complex.has_tet(first));
  std::vector<TetId> least_fragment = {first};
  double volume = 0;
  for (std::size_t n = 0; n < least_fragment.size(); ++n) {
    const TetId t = least_fragment[n];
    volume += complex.volume(t);
    if (volume > least_piece_share * complex.tables().mean_volume) return {};
    for (std::size_t k = 0; k < complex.sides(); ++k) {
      const TetId beyond = complex.neighbor(t, k);
      if (beyond == TetComplex::none ||
          std::find(least_fragment.begin(), least_fragment.end(), beyond) != least_fragment.end())
        continue;
      const std::array<TetId, 2> face = {std::min(t, beyond), std::max(t, beyond)};
      if (!std::binary_search(slit.faces.begin(), slit.faces.end(), face)) least_fragment.push_back(beyond);
    }
  }
  return least_fragment;
}

/// Removes the faces of small fragments from `slit`: a blade that follows an older cut would otherwise chip
/// off small protrusions of its walls.
void leave_crumbs(const TetComplex& complex, SlitFaces& slit) {
  PROSECTOR_ASSERT(is_ascending(slit.faces));
  bool any = false;
  std::vector<bool> in_crumb(complex.tet_end(), false);
  for (const auto& face : slit.faces)
    for (const TetId t : face) {
      if (in_crumb[t] || complex.volume(t) > least_piece_share * complex.tables().mean_volume) continue;
      const auto least_fragment = fragment_at(complex, slit, t);
      any |= !least_fragment.empty();
      for (const TetId part : least_fragment) in_crumb[part] = true;
    }
  if (!any) return;
  std::erase_if(slit.faces,
                [&](const std::array<TetId, 2>& face) { return in_crumb[face[0]] || in_crumb[face[1]]; });
}

/// Fans of a node: groups of its tetrahedra that are connected through faces at the node.
class Fans {
 public:
  explicit Fans(const TetComplex& complex) : complex_(complex), fan_of_(complex.tet_end(), none) {}

  /// Finds the node's fans and returns their number; the fan with the lowest id is the first.
  std::uint32_t find(NodeId node) {
    PROSECTOR_ASSERT(complex_.has_node(node) && fan_of_.size() == complex_.tet_end());
    const auto star = complex_.star(node);
    for (const TetId t : star) fan_of_[t] = none;
    std::uint32_t fans = 0;
    for (const TetId first : star) {
      if (fan_of_[first] != none) continue;
      fan_of_[first] = fans;
      open_.assign(1, first);
      while (!open_.empty()) {
        const TetId t = open_.back();
        open_.pop_back();
        for (std::size_t k = 0; k < complex_.sides(); ++k) {
          const TetId beyond = complex_.neighbor(t, k);
          if (beyond == none || complex_.corners(t)[k] == node || fan_of_[beyond] == fans) continue;
          fan_of_[beyond] = fans;
          open_.push_back(beyond);
        }
      }
      ++fans;
    }
    return fans;
  }
  /// Returns the fan of a tetrahedron at the node of the last call of find().
  std::uint32_t fan_of(TetId tet) const { return fan_of_[tet]; }

 private:
  static constexpr std::uint32_t none = TetComplex::none;
  const TetComplex& complex_;
  std::vector<std::uint32_t> fan_of_;
  std::vector<TetId> open_;
};

/// Duplicates the nodes of slit faces and of split edges whose tetrahedra are no longer connected. Nodes of
/// split edges are included because the tetrahedra around an edge may separate before those at its ends.
void part_nodes(TetComplex& complex, const SlitFaces& slit, std::vector<Vec3>& x, Marks& marks,
                CutResult& result) {
  PROSECTOR_ASSERT(x.size() == complex.node_end());
  std::vector<NodeId> nodes;
  for (const TopologyOp& op : result.ops)
    if (const auto* split = std::get_if<SplitEdge>(&op)) nodes.push_back(split->node);
  for (const auto& [a, b] : slit.faces)
    for (const NodeId corner : complex.corners(a))
      if (has_corner(complex, b, corner)) nodes.push_back(corner);
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  Fans fans(complex);
  for (const NodeId node : nodes) {
    const std::uint32_t count = fans.find(node);
    if (count < 2) continue;
    PROSECTOR_ASSERT(marks.find(node) != nullptr);
    PartNode op{node, std::vector<PartNode::Copy>(count - 1)};
    for (const TetId t : complex.star(node))
      if (const std::uint32_t fan = fans.fan_of(t); fan > 0) op.copies[fan - 1].tets.push_back(t);
    for (PartNode::Copy& copy : op.copies) {
      copy.node = static_cast<NodeId>(x.size());
      x.push_back(x[node]);
      BladeStroke::Mark mark = *marks.find(node);
      mark.node = copy.node;
      marks.add(mark);
    }
    complex.apply(op);
    result.ops.emplace_back(std::move(op));
    ++result.parted_nodes;
  }
}

void slit(TetComplex& complex, const SlitFaces& op, std::vector<Vec3>& x, Marks& marks, CutResult& result) {
  if (!op.faces.empty()) {
    complex.apply(op);
    result.slit_faces += op.faces.size();
    result.ops.emplace_back(op);
  }
  part_nodes(complex, op, x, marks, result);
}

/// Defers the mass updates of a complex for its lifetime.
struct DeferredMasses {
  explicit DeferredMasses(TetComplex& of) : complex(of) { complex.defer_masses(); }
  ~DeferredMasses() { complex.settle_masses(); }
  DeferredMasses(const DeferredMasses&) = delete;
  DeferredMasses& operator=(const DeferredMasses&) = delete;
  TetComplex& complex;
};

bool is_in_tissue(const BladeStroke& stroke) {
  return std::any_of(stroke.edge.begin(), stroke.edge.end(),
                     [](const BladeStroke::EdgePoint& p) { return p.tet != TetComplex::none; });
}

/// Returns the mean motion of the line, m: of its points in tissue; for a sheet, of all points.
Vec3 way_of(const BladeStroke& stroke, const TetComplex& complex, std::span<const Vec3> from,
            std::span<const Vec3> to) {
  PROSECTOR_ASSERT(from.size() == stroke.edge.size() && to.size() == from.size());
  Vec3 sum = Vec3::Zero();
  double count = 0;
  for (std::size_t i = 0; i < stroke.edge.size(); ++i) {
    if (!complex.is_sheet() && stroke.edge[i].tet == TetComplex::none) continue;
    sum += to[i] - from[i];
    ++count;
  }
  return count > 0 ? Vec3(sum / count) : sum;
}

/// Completes the cut after the line has left the body. If the line went all the way across (`crossed`)
/// instead of back, the nodes that the sweeps missed count as lying on the blade.
void end_line(TetComplex& complex, bool crossed, std::vector<Vec3>& x, Marks& marks, CutResult& result) {
  if (crossed)
    for (const NodeId node : missing_nodes(complex, marks, most_missing(complex, marks))) {
      ++result.snapped;
      marks.add(mark_between(complex, marks, node));
    }
  const double least_fragment = least_piece_share * complex.tables().mean_volume;
  if (const SlitFaces op = faces_between_parts(complex, marks, least_fragment); !op.faces.empty())
    slit(complex, op, x, marks, result);
}

}  // namespace

CutResult cut(TetComplex& complex, TetTree& tree, std::span<const Vec3> positions, std::span<const Vec3> edge,
              BladeStroke& stroke) {
  check_edge(edge);
  if (edge.size() != stroke.points())
    throw InputError(fmt::format(
        "blade: its edge has {} points, but had {} when the stroke began; the number must not change",
        edge.size(), stroke.points()));
  if (positions.size() < complex.node_end())
    throw InputError(fmt::format("cutting: {} node positions were given, but the mesh has {} nodes",
                                 positions.size(), complex.node_end()));
  CutResult result;
  const std::vector<Vec3> from = carried_edge(stroke, edge, complex, positions);
  const MovedEdge moved = moved_edge(stroke, from, edge, least_motion);
  const std::vector<Vec3>& to = moved.to;
  PROSECTOR_ASSERT(from.size() == stroke.edge.size() && to.size() == from.size());
  if (to == from) return result;

  std::vector<std::size_t> piece_of_edge;
  for (const BladeStroke::EdgePoint& p : stroke.edge) piece_of_edge.push_back(static_cast<std::size_t>(p.at));
  // In a solid, the line's points are close to each other, so twisted segments need no subdivision.
  const SweptSurface sheet(
      from, to, piece_of_edge,
      complex.is_sheet() ? SweptSurface::Twist::followed : SweptSurface::Twist::flattened);
  Vec3 low = to.front(), high = low;
  for (const std::vector<Vec3>& points : {from, to})
    for (const Vec3& x : points) {
      low = low.cwiseMin(x);
      high = high.cwiseMax(x);
    }
  tree.update(complex, positions, low, high);
  std::vector<TetId> candidates;
  for (const SweptSurface::Piece& piece : sheet.pieces()) tree.query(piece, candidates);
  std::sort(candidates.begin(), candidates.end());
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());

  std::vector<Vec3> x(positions.begin(), positions.begin() + static_cast<std::ptrdiff_t>(complex.node_end()));
  if (candidates.empty()) {
    hold_edge(stroke, moved, complex, tree, x);
    return result;
  }
  SheetPassage passage;
  if (complex.is_sheet()) passage = sheet_passage(complex, candidates, x, from, to);
  Marks marks(stroke.marks, complex.node_end());
  const DeferredMasses masses(complex);
  split_edges(complex, sheet, candidates, x, marks, result);
  SlitFaces faces = faces_to_slit(complex, marks);
  leave_crumbs(complex, faces);
  slit(complex, faces, x, marks, result);
  const bool was_in_tissue = is_in_tissue(stroke) || passage.was_in;
  const bool ended_inside = stroke.ended_inside || passage.end_came_through;
  // Tissue that was dragged along may slip off the blade on its far side without a cut in this tick.
  const Vec3 way = way_of(stroke, complex, from, to);
  const bool forward = !result.ops.empty() || way.dot(stroke.way) > same_way * way.norm() * stroke.way.norm();
  if (!result.ops.empty()) stroke.way = way;
  hold_edge(stroke, moved, complex, tree, x);
  if (complex.is_sheet()) stroke.ended_inside = passage.is_in && ended_inside;
  if (was_in_tissue && !is_in_tissue(stroke) && !passage.is_in)
    end_line(complex, forward && !ended_inside, x, marks, result);
  stroke.marks = marks.by_node();
  return result;
}

}  // namespace prosector::cutting
