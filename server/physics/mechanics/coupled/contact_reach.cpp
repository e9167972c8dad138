#include "server/physics/mechanics/coupled/contact_reach.h"

#include <algorithm>
#include <cmath>

#include "common/assert.h"

namespace prosector::coupled {
namespace {

// When the list grows, it covers this multiple of the displacements, and this more, so that it grows rarely.
constexpr double spare = 2, spare_way = 5e-5, spare_turn = 1e-3;  // m, rad
constexpr double rounding = 1e-10;                                // m

}  // namespace

void ContactReach::begin(const Island& island, const IslandLayout& layout, const VecX& start) {
  PROSECTOR_ASSERT(start.size() == layout.rigid_begin);
  layout_ = &layout;
  start_ = &start;
  ways_.assign(static_cast<std::size_t>(layout.rigid_begin / 3), 0);
  twists_.assign(island.rigid.size(), {});
  nodes_.clear();
  openings_.clear();
  for (const contact::Contact& c : island.contacts) openings_.push_back(opening_of(c));
  list();
}

ContactReach::Side ContactReach::side_of(const contact::ContactSide& side) {
  Side out;
  if (side.kind == contact::ContactSide::Kind::soft) {
    const auto before = static_cast<std::uint32_t>(layout_->soft[layout_->soft_members[side.body]] / 3);
    out.first = static_cast<std::uint32_t>(nodes_.size());
    for (std::size_t k = 0; k < side.nodes; ++k) {
      nodes_.push_back(before + side.node[k]);
      out.weight += std::abs(side.weight[k]);
    }
    out.end = static_cast<std::uint32_t>(nodes_.size());
  } else if (side.kind == contact::ContactSide::Kind::rigid) {
    out.rigid = static_cast<std::uint32_t>(layout_->rigid_members[side.body]);
    out.arm = side.arm.norm();
  }
  return out;
}

ContactReach::Opening ContactReach::opening_of(const contact::Contact& c) {
  const double gap = c.gap - c.spread - c.a.moved.norm() - c.b.moved.norm() - rounding;
  if (c.a.kind != contact::ContactSide::Kind::soft || !(gap >= 0)) return {-1, {}, {}};
  return {gap, side_of(c.a), side_of(c.b)};
}

/// Returns the largest displacement of the side that the list covers, m.
double ContactReach::most_closing(const Side& side) const {
  if (side.rigid != Side::none) return twists_[side.rigid].way + side.arm * twists_[side.rigid].turn;
  double way = 0;
  for (std::uint32_t k = side.first; k < side.end; ++k) way = std::max(way, ways_[nodes_[k]]);
  return side.weight * way;
}

bool ContactReach::may_act(const Opening& opening) const {
  return opening.gap < 0 || !(most_closing(opening.a) + most_closing(opening.b) <= opening.gap);
}

void ContactReach::list() {
  listed_.clear();
  for (std::uint32_t c = 0; c < openings_.size(); ++c)
    if (may_act(openings_[c])) listed_.push_back(c);
}

/// Extends what the list covers to the nodes' displacements at the unknowns q. Returns whether it had to.
bool ContactReach::extend_nodes(const VecX& q) {
  bool grows = false;
  for (std::size_t n = 0; n < ways_.size(); ++n) {
    const auto at = static_cast<Eigen::Index>(3 * n);
    const double square = (q.segment<3>(at) - start_->segment<3>(at)).squaredNorm();
    if (square <= ways_[n] * ways_[n]) continue;
    grows = true;
    ways_[n] = spare * std::sqrt(square) + spare_way;
  }
  return grows;
}

/// Does the same for rigid bodies.
bool ContactReach::extend_rigid(const VecX& q) {
  bool grows = false;
  for (std::size_t m = 0; m < twists_.size(); ++m) {
    const Eigen::Index at = layout_->rigid(m);
    const Twist now = {q.segment<3>(at).norm(), q.segment<3>(at + 3).norm()};
    if (now.way <= twists_[m].way && now.turn <= twists_[m].turn) continue;
    grows = true;
    twists_[m] = {spare * now.way + spare_way, spare * now.turn + spare_turn};
  }
  return grows;
}

bool ContactReach::cover(const VecX& q) {
  PROSECTOR_ASSERT(layout_ != nullptr && q.size() == layout_->size);
  if (listed_.size() == openings_.size()) return false;
  const bool nodes = extend_nodes(q), rigid = extend_rigid(q);
  if (!nodes && !rigid) return false;
  const std::size_t before = listed_.size();
  list();
  return listed_.size() != before;
}

}  // namespace prosector::coupled
