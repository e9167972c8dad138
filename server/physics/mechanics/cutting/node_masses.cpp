#include "server/physics/mechanics/cutting/node_masses.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/assert.h"
#include "common/error.h"
#include "server/physics/mechanics/cutting/sheet_mass.h"

namespace prosector::cutting {

NodeMasses::NodeMasses(double density) : density_(density) {
  if (!(density > 0) || !std::isfinite(density))
    throw InputError(fmt::format("cutting: density is {}; allowed: positive, in kg/m³", density));
}

void NodeMasses::grow(std::size_t end) {
  if (end <= mass_.size()) return;
  mass_.resize(end, 0.0);
  held_.resize(end, 0);
  stale_.resize(end, 0);
}

void NodeMasses::start(const TetTables& tables) {
  PROSECTOR_ASSERT(!tables.is_sheet() && tables.star.size() == tables.rest.size());
  grow(tables.rest.size());
  for (NodeId i = 0; i < tables.rest.size(); ++i) find(tables, i);
}

void NodeMasses::start_sheet(std::span<const double> volumes, std::vector<std::uint8_t> held) {
  PROSECTOR_ASSERT(held.empty() || held.size() == volumes.size());
  grow(volumes.size());
  if (!held.empty()) held_ = std::move(held);
  for (NodeId i = 0; i < volumes.size(); ++i) mass_[i] = density_ * volumes[i];
}

void NodeMasses::settle(const TetTables& tables) {
  PROSECTOR_ASSERT(unsettled_.empty() || deferred_);
  deferred_ = false;
  for (const NodeId node : unsettled_) {
    find(tables, node);
    stale_[node] = 0;
  }
  unsettled_.clear();
}

void NodeMasses::update(const TetTables& tables, NodeId node) {
  PROSECTOR_ASSERT(!tables.is_sheet() && node < mass_.size() && node < tables.star.size());
  if (!deferred_) return find(tables, node);
  if (!stale_[node]) unsettled_.push_back(node);
  stale_[node] = 1;
}

// Sums in the order of ids, so the result does not depend on the history of the star.
void NodeMasses::find(const TetTables& tables, NodeId node) {
  double volume = 0;
  for (const TetId t : tables.star[node]) volume += tables.tet[t].volume;
  mass_[node] = density_ * volume / 4;
}

void NodeMasses::update_around(const TetTables& tables, std::span<const TetId> tets) {
  if (deferred_) {
    for (const TetId t : tets)
      for (const NodeId node : tables.tet[t].corner) update(tables, node);
    return;
  }
  met_.clear();
  for (const TetId t : tets)
    for (const NodeId node : tables.tet[t].corner)
      if (std::find(met_.begin(), met_.end(), node) == met_.end()) met_.push_back(node);
  for (const NodeId node : met_) update(tables, node);
}

void NodeMasses::share(const SplitEdge& op) {
  PROSECTOR_ASSERT(op.a < mass_.size() && op.b < mass_.size() && op.node < mass_.size() && op.t > 0 &&
                   op.t < 1);
  const bool at_a = is_held(op.a), at_b = is_held(op.b);
  before_.resize(mass_.size());
  before_[op.node] = {mass_[op.a], mass_[op.b]};
  const EdgeMasses now = share_mass({mass_[op.a], at_a}, {mass_[op.b], at_b}, op.t);
  mass_[op.a] = now.a;
  mass_[op.b] = now.b;
  mass_[op.node] = now.node;
  held_[op.node] = at_a && at_b;
}

/// Distributes the node's mass in proportion to the areas of the node and its copies.
void NodeMasses::share(const TetTables& tables, const PartNode& op) {
  PROSECTOR_ASSERT(tables.is_sheet() && !op.copies.empty() && op.copies.back().node < mass_.size());
  const auto area = [&](NodeId node) {
    double sum = 0;
    for (const TetId t : tables.star[node]) sum += tables.tet[t].volume;
    return sum;
  };
  const double whole = mass_[op.node];
  double sum = area(op.node);
  for (const auto& copy : op.copies) sum += area(copy.node);
  before_.resize(mass_.size());
  before_[op.copies.front().node] = {whole, 0};
  for (const auto& copy : op.copies) {
    mass_[copy.node] = whole * area(copy.node) / sum;
    held_[copy.node] = held_[op.node];
  }
  mass_[op.node] = whole * area(op.node) / sum;
}

void NodeMasses::share_back(const SplitEdge& op) {
  PROSECTOR_ASSERT(op.node < before_.size());
  mass_[op.a] = before_[op.node].a;
  mass_[op.b] = before_[op.node].b;
}

void NodeMasses::share_back(const PartNode& op) {
  PROSECTOR_ASSERT(!op.copies.empty() && op.copies.front().node < before_.size());
  mass_[op.node] = before_[op.copies.front().node].a;
}

}  // namespace prosector::cutting
