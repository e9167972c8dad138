#pragma once
// Lumped masses of a complex's nodes, updated after each cut. A node gets ρV/4 of each of its tetrahedra. The
// nodes of a sheet redistribute existing mass, see sheet_mass.h.

#include <cstdint>
#include <span>
#include <vector>

#include "server/physics/mechanics/cutting/tet_tables.h"

namespace prosector {

class NodeMasses {
 public:
  /// Takes the density, kg/m³. Throws InputError unless it is positive.
  explicit NodeMasses(double density);

  double density() const { return density_; }
  double of(NodeId node) const { return mass_[node]; }          // kg
  bool is_held(NodeId node) const { return held_[node] != 0; }  // sheets: fixed in position
  void grow(std::size_t end);

  /// Computes the masses of tetrahedra that were never cut.
  void start(const TetTables& tables);
  /// Computes the masses of a sheet from its node volumes, m³. `held`: by node, 1 if fixed in position;
  /// empty: none.
  void start_sheet(std::span<const double> volumes, std::vector<std::uint8_t> held);

  /// Defers the mass sums of tetrahedra's nodes to settle(). Until then the masses of changed nodes are
  /// stale.
  void defer() { deferred_ = true; }
  void settle(const TetTables& tables);

  // Tetrahedra: a node's mass follows from the tetrahedra at the node.
  void update(const TetTables& tables, NodeId node);
  /// Updates the corners of the tetrahedra around one edge.
  void update_around(const TetTables& tables, std::span<const TetId> tets);

  // Sheets: distribute the mass of existing nodes to an operation's new nodes, and undo this.
  void share(const SplitEdge& op);
  void share(const TetTables& tables, const PartNode& op);
  void share_back(const SplitEdge& op);
  void share_back(const PartNode& op);

 private:
  void find(const TetTables& tables, NodeId node);

  /// Masses before an operation, kg.
  struct Before {
    double a = 0, b = 0;  // of the split edge's ends; a: also of a node before it was duplicated
  };

  double density_;
  std::vector<double> mass_;
  std::vector<std::uint8_t> held_;
  std::vector<Before> before_;       // sheets: by the operation's new node (PartNode: its first copy)
  std::vector<std::uint8_t> stale_;  // by node
  std::vector<NodeId> unsettled_;    // the stale nodes
  std::vector<NodeId> met_;          // scratch
  bool deferred_ = false;
};

}  // namespace prosector
