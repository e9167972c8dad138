#include "server/physics/mechanics/cutting/missing_nodes.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "common/assert.h"

namespace prosector::cutting {
namespace {

using Vertex = std::uint32_t;
constexpr Vertex no_vertex = UINT32_MAX;
// Sine of the elevation angle over a mark's plane below which a node is on neither side of the mark.
constexpr double flat = 0.2;

/// Graph of the tissue around a cut. Each unmarked node adjacent to a mark is a vertex (a `unit`, which may
/// be missing from the cut). Each connected region of the other nodes is one vertex. A unit can lie above or
/// below the planes of the marks adjacent to it.
class Surroundings {
 public:
  Surroundings(const TetComplex& complex, const Marks& marks)
      : complex_(complex), of_(complex.node_end(), no_vertex), is_met_(complex.tet_end(), 0) {
    for (const BladeStroke::Mark& mark : marks.all())
      if (complex.has_node(mark.node)) of_[mark.node] = marked;
    find_units(marks);
    if (sees(from_above) && sees(from_below)) join_units();
  }

  std::size_t size() const { return nodes_.size() + others_.size(); }
  bool is_unit(Vertex v) const { return v < nodes_.size(); }
  NodeId node(Vertex unit) const { return nodes_[unit]; }
  bool is_above(Vertex v) const { return is_unit(v) && seen_[v] == from_above; }
  bool is_below(Vertex v) const { return is_unit(v) && seen_[v] == from_below; }
  std::span<const Vertex> neighbors(Vertex v) const {
    PROSECTOR_ASSERT(v < size());
    if (!is_unit(v)) return others_[v - nodes_.size()];
    return begin_.empty() ? std::span<const Vertex>()
                          : std::span(beside_).subspan(begin_[v], begin_[v + 1] - begin_[v]);
  }

 private:
  static constexpr std::uint8_t from_above = 1, from_below = 2;
  static constexpr Vertex marked = no_vertex - 1;

  /// Visits the unmarked nodes adjacent to a node, possibly repeatedly, and the node itself.
  template <class Visit>
  void for_unmarked_beside(NodeId node, Visit&& visit) const {
    for (const TetId t : complex_.star(node))
      for (const NodeId corner : complex_.corners(t))
        if (of_[corner] != marked) visit(corner);
  }
  bool sees(std::uint8_t side) const { return std::find(seen_.begin(), seen_.end(), side) != seen_.end(); }

  void find_units(const Marks& marks) {
    std::vector<NodeId> seen_by(complex_.node_end(), no_vertex);
    std::vector<std::uint8_t> seen(complex_.node_end(), 0);
    for (const BladeStroke::Mark& mark : marks.all()) {
      if (!complex_.has_node(mark.node)) continue;
      for_unmarked_beside(mark.node, [&](NodeId node) {
        if (std::exchange(seen_by[node], mark.node) == mark.node) return;
        const Vec3 way = complex_.rest(node) - mark.point;
        const double height = mark.normal.dot(way);
        if (std::abs(height) > flat * way.norm()) seen[node] |= height > 0 ? from_above : from_below;
      });
    }
    for (NodeId node = 0; node < seen_by.size(); ++node) {
      if (seen_by[node] == no_vertex) continue;
      of_[node] = static_cast<Vertex>(nodes_.size());
      nodes_.push_back(node);
      seen_.push_back(seen[node]);
    }
  }

  void join_units() {
    std::vector<Vertex> met_by(nodes_.size(), no_vertex);
    for (Vertex unit = 0; unit < nodes_.size(); ++unit) {
      begin_.push_back(beside_.size());
      for_unmarked_beside(nodes_[unit], [&](NodeId node) {
        if (of_[node] == no_vertex) {
          fill(node);
          met_by.push_back(no_vertex);
        }
        const Vertex other = of_[node];
        if (other == unit || std::exchange(met_by[other], unit) == unit) return;
        beside_.push_back(other);
        if (!is_unit(other)) others_[other - nodes_.size()].push_back(unit);
      });
    }
    begin_.push_back(beside_.size());
  }

  /// Creates one vertex for all nodes that are connected with `first` without passing through units.
  void fill(NodeId first) {
    PROSECTOR_ASSERT(of_[first] == no_vertex);
    const auto vertex = static_cast<Vertex>(size());
    others_.emplace_back();
    open_.assign(1, first);
    of_[first] = vertex;
    while (!open_.empty()) {
      const NodeId from = open_.back();
      open_.pop_back();
      for (const TetId t : complex_.star(from)) {
        if (std::exchange(is_met_[t], 1) != 0) continue;  // all its corners have been visited
        for (const NodeId node : complex_.corners(t))
          if (of_[node] == no_vertex) {
            of_[node] = vertex;
            open_.push_back(node);
          }
      }
    }
  }

  const TetComplex& complex_;
  std::vector<Vertex> of_;            // vertex, by node
  std::vector<std::uint8_t> is_met_;  // by tetrahedron: already visited
  std::vector<NodeId> nodes_;         // node, by unit; ascending
  std::vector<std::uint8_t> seen_;    // by unit: sides on which marks see the unit
  std::vector<std::size_t> begin_;    // by unit: start of its neighbours in beside_
  std::vector<Vertex> beside_;
  std::vector<std::vector<Vertex>> others_;  // neighbouring units of each vertex that is not a unit
  std::vector<NodeId> open_;                 // scratch
};

/// Vertex-disjoint paths from above to below, by Dinic's algorithm. Each unit is split into two places, an
/// entry and an exit, which the paths of a phase use once each. The paths of a phase all have the length of
/// its shortest path. Any number of paths may pass through a vertex that is not a unit. `sides_hold`: units
/// above or below cannot be missing nodes, so paths may share them.
class Paths {
 public:
  Paths(const Surroundings& around, bool sides_hold)
      : around_(around),
        sides_hold_(sides_hold),
        used_(around.size(), 0),
        before_(around.size(), no_vertex),
        after_(around.size(), no_vertex) {
    for (Vertex v = 0; v < around.size(); ++v) {
      const auto beside = around.neighbors(v);
      const auto is_below = [&](Vertex other) { return around.is_below(other); };
      ends_.push_back(sides_hold ? std::any_of(beside.begin(), beside.end(), is_below) : is_below(v));
    }
  }

  /// Finds paths and returns their number, at most `most`.
  std::size_t find(std::size_t most) {
    std::size_t found = 0;
    while (found < most && measure_depths()) {
      next_.assign(around_.size(), 0);
      for (Vertex v = 0; v < around_.size(); ++v)
        while (found < most && around_.is_above(v) && add_one_from(source(v))) ++found;
    }
    return found;
  }
  /// Returns the minimum vertex cut. Valid after find() has found fewer paths than its limit.
  std::vector<NodeId> bottleneck() const {
    PROSECTOR_ASSERT(depth_.size() == 2 * around_.size());
    std::vector<NodeId> nodes;
    for (Vertex v = 0; v < around_.size() && around_.is_unit(v); ++v)
      if (depth_[in(v)] != unseen && depth_[out(v)] == unseen) nodes.push_back(around_.node(v));
    return nodes;
  }

 private:
  using Place = std::uint32_t;
  static constexpr std::uint32_t unseen = UINT32_MAX;
  static Place in(Vertex v) { return 2 * v; }
  static Place out(Vertex v) { return 2 * v + 1; }
  static bool is_in(Place place) { return place % 2 == 0; }
  Place source(Vertex v) const { return sides_hold_ ? out(v) : in(v); }
  bool is_shared(Vertex v) const { return !around_.is_unit(v) || (sides_hold_ && around_.is_above(v)); }

  /// Returns the only next place after the entry of a unit; `unseen` if the unit's own path begins there.
  Place way_on(Vertex v) const {
    if (!used_[v]) return out(v);
    return before_[v] != no_vertex ? out(before_[v]) : unseen;
  }
  /// Returns the residual arcs from the exit of `v` to a neighbour: to its entry, and back along a path that
  /// leads from the neighbour to `v`.
  std::array<Place, 2> ways_to(Vertex next, Vertex v) const {
    if (!around_.is_unit(next)) return {out(next), unseen};
    const bool back = !around_.is_unit(v) && used_[next] && after_[next] == v;
    return {is_shared(next) ? unseen : in(next), back ? out(next) : unseen};
  }

  /// Computes the level of each place, its distance from above, by breadth-first search up to the nearest
  /// end. Returns whether an end was reached.
  bool measure_depths() {
    depth_.assign(2 * around_.size(), unseen);
    open_.clear();
    const auto reach = [&](Place place, std::uint32_t depth) {
      if (place == unseen || depth_[place] != unseen) return;
      depth_[place] = depth;
      open_.push_back(place);
    };
    for (Vertex v = 0; v < around_.size(); ++v)
      if (around_.is_above(v)) reach(source(v), 0);
    deepest_ = unseen;
    for (std::size_t n = 0; n < open_.size(); ++n) {
      const Place place = open_[n];
      const Vertex v = place / 2;
      const std::uint32_t depth = depth_[place];
      if (depth >= deepest_) break;
      if (is_in(place)) {
        reach(way_on(v), depth + 1);
      } else if (ends_[v]) {
        deepest_ = depth;
      } else {
        if (used_[v]) reach(in(v), depth + 1);
        for (const Vertex next : around_.neighbors(v))
          for (const Place way : ways_to(next, v)) reach(way, depth + 1);
      }
    }
    return deepest_ != unseen;
  }

  /// Adds one path along places of increasing level by depth-first search. Skips places that a path of this
  /// phase uses and dead ends.
  bool add_one_from(Place source) {
    if (depth_[source] != 0) return false;
    way_.assign(1, source);
    while (!way_.empty()) {
      const Place place = way_.back();
      if (!is_in(place) && ends_[place / 2]) {
        take_way();
        return true;
      }
      if (const Place next = deeper(place); next != unseen) {
        way_.push_back(next);
      } else {
        depth_[place] = unseen;
        way_.pop_back();
      }
    }
    return false;
  }
  Place deeper(Place place) {
    const Vertex v = place / 2;
    const std::uint32_t depth = depth_[place] + 1;
    const auto leads = [&](Place way) { return way != unseen && depth_[way] == depth; };
    if (depth > deepest_) return unseen;
    if (is_in(place)) return leads(way_on(v)) ? way_on(v) : unseen;
    if (used_[v] && leads(in(v))) return in(v);
    const auto beside = around_.neighbors(v);
    for (std::uint32_t& n = next_[v]; n < beside.size(); ++n)
      for (const Place way : ways_to(beside[n], v))
        if (leads(way)) return way;
    return unseen;
  }
  void take_way() {
    PROSECTOR_ASSERT(!way_.empty());
    for (std::size_t n = 0; n < way_.size(); ++n) {
      const Place place = way_[n];
      const Vertex v = place / 2, from = n > 0 ? way_[n - 1] / 2 : no_vertex;
      if (is_in(place) && from != v) before_[v] = from;
      if (!is_in(place) && from == v) used_[v] = 1;
      if (is_in(place) && from == v) used_[v] = 0;
      if (!is_in(place) && n + 1 < way_.size()) after_[v] = way_[n + 1] / 2;
      if (!is_shared(v)) depth_[place] = unseen;
    }
    after_[way_.back() / 2] = no_vertex;
  }

  const Surroundings& around_;
  bool sides_hold_;
  // By vertex. used_: whether a path uses the unit. ends_: whether a path may end here. That is at a vertex
  // below or, if sides_hold_, adjacent to a vertex below.
  std::vector<std::uint8_t> used_, ends_;
  std::vector<Vertex> before_, after_;  // previous and next vertex on a unit's path; nobody: none
  std::vector<std::uint32_t> depth_;    // level, by place
  std::vector<std::uint32_t> next_;     // by vertex: number of its neighbours already tried in this phase
  std::vector<Place> open_, way_;
  std::uint32_t deepest_ = unseen;
};

}  // namespace

std::size_t most_missing(const TetComplex& complex, const Marks& marks) {
  constexpr double share = 0.05;  // relative to the number of marked nodes
  const std::size_t anyway = complex.is_sheet() ? 1 : 4;
  return std::max(anyway, static_cast<std::size_t>(share * static_cast<double>(marks.all().size())));
}

std::vector<NodeId> missing_nodes(const TetComplex& complex, const Marks& marks, std::size_t most) {
  const Surroundings around(complex, marks);
  Paths through_all(around, false);
  const std::size_t fewest = through_all.find(most + 1);  // here units on one side may be removed too
  if (fewest == 0 || fewest > most) return {};
  Paths between_sides(around, true);
  return between_sides.find(most + 1) <= most ? between_sides.bottleneck() : through_all.bottleneck();
}

}  // namespace prosector::cutting
