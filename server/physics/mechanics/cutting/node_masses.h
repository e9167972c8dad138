#pragma once
// Lumped masses of a complex's nodes, updated after each cut. A node gets ρV/4 of each of its tetrahedra. The
// nodes of a sheet redistribute existing mass, see sheet_mass.h.

#include <cstdint>
#include <span>
#include <vector>

#include "server/physics/mechanics/cutting/tet_tables.h"

namespace prosector::cutting {

class NodeMasses {
 public:
  /// Creates an empty list of node masses. `density`, kg/m³. Throws InputError unless it is positive and
  /// finite.
  explicit NodeMasses(double density);

  double density() const { return density_; }
  double of(NodeId node) const { return mass_[node]; }          // kg
  bool is_held(NodeId node) const { return held_[node] != 0; }  // sheets: fixed in position
  void grow(std::size_t end);

  /// Computes the mass of each node of an uncut tetrahedral mesh: density times a quarter of the volume of
  /// its tetrahedra.
  void start(const TetTables& tables);
  /// Computes the masses of an uncut sheet's nodes from the volumes, m³, that belong to the nodes. `held`:
  /// for each node, 1 if it is fixed in position; empty if no node is.
  void start_sheet(std::span<const double> volumes, std::vector<std::uint8_t> held);

  /// Postpones the mass sums of nodes of tetrahedra until settle() is called, so that each is computed once.
  /// Until then the masses of changed nodes are outdated.
  void defer() { deferred_ = true; }
  void settle(const TetTables& tables);

  // Tetrahedra: a node's mass follows from the tetrahedra at the node.
  void update(const TetTables& tables, NodeId node);
  /// Updates the masses of all corners of these tetrahedra, which are those around one edge, after a change
  /// of the tetrahedra.
  void update_around(const TetTables& tables, std::span<const TetId> tets);

  // Sheets: distribute the mass of existing nodes to an operation's new nodes, and undo this.
  void share(const SplitEdge& op);
  void share(const TetTables& tables, const PartNode& op);
  void share_back(const SplitEdge& op);
  void share_back(const PartNode& op);

 private:
  void find(const TetTables& tables, NodeId node);

  /// Masses of a sheet's nodes before an operation, kg, stored to undo the operation exactly.
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

}  // namespace prosector::cutting
