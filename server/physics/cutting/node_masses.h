#pragma once
// Lumped masses of a complex's nodes, kept up to date with its cuts. A node of tetrahedra has ρV/4 of each of
// its own; a sheet's nodes share what they have, see sheet_mass.h.

#include <cstdint>
#include <span>
#include <vector>

#include "server/physics/cutting/tet_tables.h"

namespace prosector {

class NodeMasses {
 public:
  /// Takes the density, kg/m³. Throws InputError unless it is positive.
  explicit NodeMasses(double density);

  double density() const { return density_; }
  double of(NodeId node) const { return mass_[node]; }          // kg
  bool is_held(NodeId node) const { return held_[node] != 0; }  // of sheets: tied to its place
  void grow(std::size_t end);

  /// Finds the masses of tetrahedra that were never cut.
  void start(const TetTables& tables);
  /// Finds those of a sheet by its node volumes, m³. `held`: by node, what is tied to its place; empty:
  /// nothing.
  void start_sheet(std::span<const double> volumes, std::vector<std::uint8_t> held);

  /// Postpones the sums of tetrahedra's nodes to settle(): until then masses of what changes are stale.
  void defer() { deferred_ = true; }
  void settle(const TetTables& tables);

  // Tetrahedra: a node's mass follows from its star.
  void update(const TetTables& tables, NodeId node);
  /// Updates the corners of the tetrahedra around one edge.
  void update_around(const TetTables& tables, std::span<const TetId> tets);

  // Sheets: before an operation's nodes have shares of what theirs had, and back.
  void share(const SplitEdge& op);
  void share(const TetTables& tables, const PartNode& op);
  void share_back(const SplitEdge& op);
  void share_back(const PartNode& op);

 private:
  void find(const TetTables& tables, NodeId node);

  /// Masses before an operation, kg.
  struct Before {
    double a = 0, b = 0;  // of the split edge's ends; of a node that parted: a
  };

  double density_;
  std::vector<double> mass_;
  std::vector<std::uint8_t> held_;
  std::vector<Before> before_;  // of sheets, by the node that the operation brought (PartNode: its first)
  std::vector<std::uint8_t> stale_;  // by node
  std::vector<NodeId> unsettled_;    // the stale ones
  std::vector<NodeId> met_;          // scratch
  bool deferred_ = false;
};

}  // namespace prosector
