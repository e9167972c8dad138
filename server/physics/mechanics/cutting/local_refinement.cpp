#include "server/physics/mechanics/cutting/local_refinement.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "common/assert.h"
#include "common/error.h"

namespace prosector::cutting {
namespace {

constexpr std::size_t most_at_once = 600;  // most tetrahedra added in one tick
// Relative to the reach: refinement starts only when an element that is too large is at most this far from a
// touched place.
constexpr double near_share = 0.7;
constexpr double half_way = 0.5;  // position on an edge at which it is bisected
// Ratio of used ids to the largest number of tetrahedra, above which the ids count as sparse.
constexpr std::size_t most_sparse = 4;

}  // namespace

LocalRefinement::LocalRefinement(const TetMesh& rest, double density, const RefinementLimits& limits)
    : limits_(limits),
      complex_(rest, density),
      compiled_nodes_(complex_.node_end()),
      compiled_tets_(complex_.tet_end()) {}

std::vector<RefinementStep> LocalRefinement::follow(const TouchedPlaces& touched, bool resting, bool settle) {
  std::vector<RefinementStep> steps;
  keep_touched(touched, resting);
  if (settle && !resting) coarsen(0, steps);
  if (!touched.empty()) refine(touched, steps);
  return steps;
}

bool LocalRefinement::is_sparse() const {
  return complex_.tet_end() > most_sparse * (complex_.tets() + limits_.most);
}

std::vector<RefinementStep> LocalRefinement::take_back() {
  std::vector<RefinementStep> steps;
  coarsen(limits_.linger, steps);
  return steps;
}

/// Restarts the linger time of touched bisections and counts down the linger time of the others.
void LocalRefinement::keep_touched(const TouchedPlaces& touched, bool resting) {
  for (Split& split : splits_) {
    if (is_touched(touched, split))
      split.left = limits_.linger;
    else if (!resting && split.left > 0)
      --split.left;
  }
}

/// Returns whether the edge, if it were whole, would be bisected again for the touched places.
bool LocalRefinement::is_touched(const TouchedPlaces& touched, const Split& split) const {
  PROSECTOR_ASSERT(split.op.count > 0);
  for (TetId half = split.op.first; half < split.op.first + 2 * split.op.count; half += 2)
    if (const RestBox box = box_of(complex_.lineage(half).parent);
        touched.within(box.low, box.high, limits_.reach))
      return true;
  return false;
}

LocalRefinement::RestBox LocalRefinement::box_of(TetId tet) const {
  const auto corners = complex_.corners(tet);
  RestBox box = {complex_.rest(corners[0]), complex_.rest(corners[0])};
  for (const NodeId corner : corners.subspan(1)) {
    box.low = box.low.cwiseMin(complex_.rest(corner));
    box.high = box.high.cwiseMax(complex_.rest(corner));
  }
  return box;
}

/// Returns the longest edge of a tetrahedron; computed once.
const LocalRefinement::RankedEdge& LocalRefinement::longest_edge(TetId tet) {
  PROSECTOR_ASSERT(tet < complex_.tet_end());
  if (tet >= longest_.size()) longest_.resize(complex_.tet_end());
  RankedEdge& longest = longest_[tet];
  if (longest.squared >= 0) return longest;
  const auto corners = complex_.corners(tet);
  for (std::size_t i = 0; i < corners.size(); ++i)
    for (std::size_t j = i + 1; j < corners.size(); ++j) {
      const auto [a, b] = std::minmax(corners[i], corners[j]);
      longest = std::max(longest, {(complex_.rest(b) - complex_.rest(a)).squaredNorm(), a, b});
    }
  return longest;
}

/// Returns the tetrahedra that are too large near touched places, the nearest first.
std::vector<LocalRefinement::Wanted> LocalRefinement::too_large(const TouchedPlaces& touched) {
  std::vector<Wanted> out;
  for (TetId tet = 0; tet < complex_.tet_end(); ++tet) {
    if (!complex_.has_tet(tet)) continue;
    if (longest_edge(tet).squared <= limits_.edge * limits_.edge) continue;
    const RestBox box = box_of(tet);
    const double off = touched.distance(box.low, box.high, limits_.reach);
    if (off < limits_.reach) out.push_back({off, tet});
  }
  std::sort(out.begin(), out.end(), [](const Wanted& a, const Wanted& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.tet < b.tet;
  });
  return out;
}

bool LocalRefinement::may_add(std::size_t tets, std::size_t at_begin) const {
  PROSECTOR_ASSERT(complex_.tets() >= compiled_tets_);
  return added() + tets <= limits_.most && complex_.tets() + tets <= at_begin + most_at_once;
}

void LocalRefinement::refine(const TouchedPlaces& touched, std::vector<RefinementStep>& steps) {
  std::vector<Wanted> wanted = too_large(touched);
  if (wanted.empty() || wanted.front().distance > near_share * limits_.reach) return;
  if (added() + wanted.size() > limits_.most) {  // undo bisections that are no longer touched
    coarsen(limits_.linger - 1, steps);
    wanted = too_large(touched);
  }
  const std::size_t at_begin = complex_.tets();
  for (bool room = true; room && !wanted.empty(); wanted = too_large(touched))
    for (const Wanted& next : wanted) {
      while (room && complex_.has_tet(next.tet)) room = split_longest_beside(next.tet, at_begin, steps);
      if (!room) return;
    }
}

/// Bisects the edge found by following longer and longer edges from the tetrahedron (longest-edge propagation
/// path). Returns false, and changes nothing, if the limits forbid the bisection or a half would have no
/// volume.
bool LocalRefinement::split_longest_beside(TetId tet, std::size_t at_begin,
                                           std::vector<RefinementStep>& steps) {
  RankedEdge edge = longest_edge(tet);
  for (bool longest = false; !longest;) {
    longest = true;
    complex_.tables().around_edge(edge.a, edge.b, around_);
    for (const TetId beside : around_)
      if (const RankedEdge other = longest_edge(beside); edge < other) {
        edge = other;
        longest = false;
      }
  }
  if (!may_add(around_.size(), at_begin)) return false;
  try {
    split(edge.a, edge.b, steps);
    return true;
  } catch (const InputError&) {  // the tetrahedron is so flat that a half has no volume after rounding
    return false;
  }
}

void LocalRefinement::split(NodeId a, NodeId b, std::vector<RefinementStep>& steps) {
  complex_.tables().around_edge(a, b, around_);
  const SplitEdge op{.a = a,
                     .b = b,
                     .node = static_cast<NodeId>(complex_.node_end()),
                     .t = half_way,
                     .first = static_cast<TetId>(complex_.tet_end()),
                     .count = static_cast<std::uint32_t>(around_.size())};
  complex_.apply(op);
  splits_.push_back({op, limits_.linger});
  steps.push_back({op});
}

bool LocalRefinement::can_take_back(const SplitEdge& op) const {
  if (complex_.star(op.node).size() != 2 * std::size_t{op.count}) return false;
  for (TetId half = op.first; half < op.first + 2 * op.count; ++half)
    if (!complex_.has_tet(half)) return false;
  return true;
}

/// Undoes bisections that have at most `left` ticks to stay and whose halves are not split further, the
/// newest first.
void LocalRefinement::coarsen(std::uint32_t left, std::vector<RefinementStep>& steps) {
  std::vector<Split> stay;
  for (auto split = splits_.rbegin(); split != splits_.rend(); ++split) {
    const SplitEdge& op = split->op;
    if (split->left > left || !can_take_back(op)) {
      stay.push_back(*split);
      continue;
    }
    RefinementStep& step = steps.emplace_back(RefinementStep{op, false});
    step.node_mass = complex_.mass(op.node);
    complex_.take_back(op);
    step.a_mass = complex_.mass(op.a);
    step.b_mass = complex_.mass(op.b);
  }
  splits_.assign(stay.rbegin(), stay.rend());
}

std::vector<RefinedEdge> LocalRefinement::edges() const {
  const auto number = [&](NodeId node) {
    if (node < compiled_nodes_) return node;
    const auto made = std::lower_bound(splits_.begin(), splits_.end(), node,
                                       [](const Split& split, NodeId id) { return split.op.node < id; });
    return static_cast<NodeId>(compiled_nodes_ + static_cast<std::size_t>(made - splits_.begin()));
  };
  std::vector<RefinedEdge> out;
  for (const Split& split : splits_) out.push_back({number(split.op.a), number(split.op.b), split.left});
  return out;
}

LocalRefinement LocalRefinement::compacted(const TetMesh& rest) const {
  LocalRefinement made = unrefined(rest);
  made.bisect(edges());
  PROSECTOR_ASSERT(made.complex_.nodes() == complex_.nodes() && made.complex_.tets() == complex_.tets());
  return made;
}

void LocalRefinement::bisect(std::span<const RefinedEdge> edges) {
  std::vector<RefinementStep> steps;
  for (const auto& [a, b, left] : edges) {
    if (!complex_.has_node(a) || !complex_.has_node(b) || a == b)
      throw InputError("a refinement: nonexistent edge");
    split(a, b, steps);
    splits_.back().left = left;
    if (left > limits_.linger || added() > limits_.most) throw InputError("a refinement: too many edges");
  }
}

}  // namespace prosector::cutting
