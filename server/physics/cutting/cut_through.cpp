#include "server/physics/cutting/cut_through.h"

#include <algorithm>

namespace prosector {
namespace {

constexpr NodeId nobody = UINT32_MAX;
constexpr double flat = 0.2;  // sine: what a mark sees flatter is on neither side of it

/// Some more than once; with the node itself.
template <class Visit>
void for_neighbors(const TetComplex& complex, NodeId node, Visit&& visit) {
  for (const TetId t : complex.star(node))
    for (const NodeId corner : complex.corners(t)) visit(corner);
}

bool is_marked_face(const TetComplex& complex, const Marks& marks, TetId tet, std::size_t k) {
  const auto corners = complex.corners(tet);
  return std::ranges::all_of(TetComplex::face[k], [&](std::size_t j) {
    return j >= corners.size() || marks.find(corners[j]) != nullptr;
  });
}

/// Nodes beside the marks, by the side on which all marks see them.
struct Sides {
  std::vector<NodeId> above;                     // ascending
  std::vector<std::uint8_t> is_above, is_below;  // by node
};

Sides sides_of(const TetComplex& complex, const Marks& marks) {
  std::vector<std::uint8_t> seen(complex.node_end(), 0);  // bits: from above, from below
  for (const BladeStroke::Mark& mark : marks.all()) {
    if (!complex.has_node(mark.node)) continue;
    for_neighbors(complex, mark.node, [&](NodeId node) {
      if (marks.find(node)) return;
      const Vec3 way = complex.rest(node) - mark.point;
      const double height = mark.normal.dot(way);
      if (std::abs(height) > flat * way.norm()) seen[node] |= height > 0 ? 1 : 2;
    });
  }
  Sides out;
  for (NodeId node = 0; node < seen.size(); ++node) {
    if (seen[node] == 1) out.above.push_back(node);
    out.is_above.push_back(seen[node] == 1);
    out.is_below.push_back(seen[node] == 2);
  }
  return out;
}

/// Paths from above to below that have no node in common. Each node is a place to come in and one to go out.
/// `sides_hold`: nodes that are seen above and below are not what is missing, so paths may share them.
class Paths {
 public:
  Paths(const TetComplex& complex, const Marks& marks, bool sides_hold)
      : complex_(complex),
        marks_(marks),
        sides_hold_(sides_hold),
        sides_(sides_of(complex, marks)),
        used_(complex.node_end(), 0),
        before_(complex.node_end(), nobody) {}

  bool add_one() {
    came_from_.assign(2 * complex_.node_end(), unseen);
    open_.clear();
    for (const NodeId node : sides_.above) reach(sides_hold_ ? out(node) : in(node), source);
    for (std::size_t n = 0; n < open_.size(); ++n) {
      const std::uint32_t place = open_[n];
      const NodeId node = place / 2;
      if (place == in(node)) {
        if (!used_[node])
          reach(out(node), place);
        else if (before_[node] != nobody)
          reach(out(before_[node]), place);
        continue;
      }
      bool arrived = !sides_hold_ && sides_.is_below[node];
      if (!arrived && used_[node]) reach(in(node), place);
      if (!arrived)
        for_neighbors(complex_, node, [&](NodeId next) {
          if (next == node || marks_.find(next) || (sides_hold_ && sides_.is_above[next])) return;
          if (sides_hold_ && sides_.is_below[next])
            arrived = true;
          else
            reach(in(next), place);
        });
      if (!arrived) continue;
      go_back(place);
      return true;
    }
    return false;
  }
  /// After add_one() found none: what keeps it from it.
  std::vector<NodeId> bottleneck() const {
    std::vector<NodeId> nodes;
    for (NodeId node = 0; node < used_.size(); ++node)
      if (came_from_[in(node)] != unseen && came_from_[out(node)] == unseen) nodes.push_back(node);
    return nodes;
  }

 private:
  static constexpr std::uint32_t unseen = UINT32_MAX, source = UINT32_MAX - 1;
  static std::uint32_t in(NodeId node) { return 2 * node; }
  static std::uint32_t out(NodeId node) { return 2 * node + 1; }
  void reach(std::uint32_t place, std::uint32_t from) {
    if (came_from_[place] != unseen) return;
    came_from_[place] = from;
    open_.push_back(place);
  }
  void go_back(std::uint32_t place) {
    while (place != source) {
      const std::uint32_t from = came_from_[place];
      const NodeId node = place / 2;
      if (place == out(node) && from == in(node))
        used_[node] = 1;
      else if (place == in(node) && from == out(node))
        used_[node] = 0;
      else if (place == in(node))
        before_[node] = from == source ? nobody : from / 2;
      place = from;
    }
  }

  const TetComplex& complex_;
  const Marks& marks_;
  bool sides_hold_;
  Sides sides_;
  std::vector<std::uint8_t> used_;
  std::vector<NodeId> before_;  // on its path; nobody: it is the first
  std::vector<std::uint32_t> came_from_, open_;
};

/// Parts of the body that hang together through faces that are not all marked.
class Parts {
 public:
  Parts(const TetComplex& complex, const Marks& marks, double crumb)
      : complex_(complex), marks_(marks), crumb_(crumb), of_(complex.tet_end(), none) {
    for (const TetId t : complex.tet_ids())
      if (of_[t] == none) fill(t);
  }
  /// What is too small to be one goes with a part beside it.
  void join_crumbs() {
    std::vector<TetId> left;
    for (const TetId t : complex_.tet_ids())
      if (!is_part_[of_[t]]) left.push_back(t);
    for (bool any = true; any;) {
      any = false;
      for (const TetId t : left)
        for (std::size_t k = 0; k < complex_.sides() && !is_part_[of_[t]]; ++k)
          if (const TetId beyond = complex_.neighbor(t, k);
              beyond != TetComplex::none && is_part_[of_[beyond]]) {
            of_[t] = of_[beyond];
            any = true;
          }
    }
  }
  /// Where nothing beside a crumb is a part, it stays as it is.
  bool differ(TetId a, TetId b) const { return of_[a] != of_[b] && is_part_[of_[a]] && is_part_[of_[b]]; }

 private:
  static constexpr std::uint32_t none = UINT32_MAX;
  void fill(TetId first) {
    const auto part = static_cast<std::uint32_t>(is_part_.size());
    double volume = 0;
    bool is_inside = false;  // has a node beside the marks
    std::vector<TetId> open = {first};
    of_[first] = part;
    while (!open.empty()) {
      const TetId t = open.back();
      open.pop_back();
      volume += complex_.volume(t);
      for (const NodeId corner : complex_.corners(t)) is_inside |= marks_.find(corner) == nullptr;
      for (std::size_t k = 0; k < complex_.sides(); ++k) {
        const TetId beyond = complex_.neighbor(t, k);
        if (beyond == TetComplex::none || of_[beyond] != none || is_marked_face(complex_, marks_, t, k))
          continue;
        of_[beyond] = part;
        open.push_back(beyond);
      }
    }
    is_part_.push_back(is_inside && volume > crumb_);
  }
  const TetComplex& complex_;
  const Marks& marks_;
  double crumb_;
  std::vector<std::uint32_t> of_;
  std::vector<bool> is_part_;
};

}  // namespace

std::vector<NodeId> missing_nodes(const TetComplex& complex, const Marks& marks, std::size_t most) {
  for (const bool sides_hold : {true, false}) {
    Paths paths(complex, marks, sides_hold);
    std::size_t found = 0;
    while (found <= most && paths.add_one()) ++found;
    if (found <= most) return paths.bottleneck();
  }
  return {};
}

BladeStroke::Mark mark_between(const TetComplex& complex, const Marks& marks, NodeId node) {
  BladeStroke::Mark out{node, complex.rest(node), Vec3::Zero()};
  for_neighbors(complex, node, [&](NodeId other) {
    if (const BladeStroke::Mark* mark = marks.find(other)) out.normal += mark->normal;
  });
  const double length = out.normal.norm();
  out.normal = length > 0 ? Vec3(out.normal / length) : Vec3::UnitX();
  return out;
}

SlitFaces faces_between_parts(const TetComplex& complex, const Marks& marks, double crumb) {
  SlitFaces op;
  for (const BladeStroke::Mark& mark : marks.all()) {
    if (!complex.has_node(mark.node)) continue;
    for (const TetId t : complex.star(mark.node))
      for (std::size_t k = 0; k < complex.sides(); ++k)
        if (const TetId beyond = complex.neighbor(t, k); beyond != TetComplex::none && t < beyond)
          if (is_marked_face(complex, marks, t, k)) op.faces.push_back({t, beyond});
  }
  if (op.faces.empty()) return op;
  std::sort(op.faces.begin(), op.faces.end());
  op.faces.erase(std::unique(op.faces.begin(), op.faces.end()), op.faces.end());
  Parts parts(complex, marks, crumb);
  parts.join_crumbs();
  std::erase_if(op.faces, [&](const std::array<TetId, 2>& f) { return !parts.differ(f[0], f[1]); });
  return op;
}

}  // namespace prosector
