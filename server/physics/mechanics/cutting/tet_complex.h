#pragma once
// Complex of tetrahedra, or of a sheet's triangles, that can be cut; neighbour relations are updated locally.
// The complex stores the rest shape only; the caller stores current positions by node id. Comments on
// tetrahedra and their faces apply to triangles and their edges too, except for masses (sheet_mass.h).
//
// The data are in tet_tables.h and node_masses.h, the operations in topology_edits.h.

#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh.h"
#include "server/physics/mechanics/cutting/node_masses.h"
#include "server/physics/mechanics/cutting/tet_tables.h"
#include "server/physics/mechanics/cutting/topology_edits.h"
#include "server/physics/mechanics/cutting/topology_op.h"

namespace prosector {

class TetComplex {
 public:
  using Corners = TetTables::Corners;
  using Origin = TetTables::Origin;
  static constexpr TetId none = TetTables::none;
  static constexpr const auto& face = TetTables::face;

  /// Takes tetrahedra of positive volume, at most two per face; `density` in kg/m³. Throws InputError that
  /// names the invalid tetrahedron.
  TetComplex(const TetMesh& rest, double density);
  /// Creates the complex of a sheet that was never cut, see tables_of_sheet(). `held`: by node, 1 if fixed in
  /// position; empty: none.
  static TetComplex of_sheet(const Anatomy& sheet, double density, std::vector<std::uint8_t> held);

  // ---- Queries by id. Ids of removed nodes and tetrahedra stay unused.
  std::size_t node_end() const { return tables_.rest.size(); }  // one past the largest id ever used
  std::size_t tet_end() const { return tables_.tet.size(); }
  std::size_t nodes() const { return tables_.live_nodes; }
  std::size_t tets() const { return tables_.live_tets; }
  bool has_node(NodeId node) const { return tables_.has_node(node); }
  bool has_tet(TetId tet) const { return tables_.has_tet(tet); }
  const Vec3& rest(NodeId node) const { return tables_.rest[node]; }             // m
  double mass(NodeId node) const { return masses_.of(node); }                    // kg
  bool is_held(NodeId node) const { return masses_.is_held(node); }              // sheets: fixed in position
  std::span<const TetId> star(NodeId node) const { return tables_.star[node]; }  // ascending
  bool is_sheet() const { return tables_.is_sheet(); }
  std::size_t sides() const { return tables_.sides; }  // corners of a tetrahedron: 4, or 3 for triangles
  /// Returns the ids of the `sides()` corners; also valid for a tetrahedron that was split.
  std::span<const NodeId> corners(TetId tet) const { return tables_.corners(tet); }
  /// Returns the index of the node among the tetrahedron's corners; 4: none.
  std::size_t corner_index(TetId tet, NodeId node) const { return tables_.corner_index(tet, node); }
  double volume(TetId tet) const { return tables_.tet[tet].volume; }  // m³, in the rest shape
  /// Returns the tetrahedron across the face opposite corner k; none at the boundary.
  TetId neighbor(TetId tet, std::size_t k) const { return tables_.tet[tet].beyond[k]; }
  /// Returns whether the face opposite corner k was created by a cut.
  bool is_wall(TetId tet, std::size_t k) const { return (tables_.tet[tet].wall >> k & 1) != 0; }
  const Lineage& lineage(TetId tet) const { return tables_.tet[tet].lineage; }
  double density() const { return masses_.density(); }  // kg/m³
  std::uint64_t undone() const { return undone_; }      // number of operations taken back
  const TetTables& tables() const { return tables_; }

  // ---- Changes. For an invalid operation, apply() and take_back() throw InputError and change nothing.
  /// Applies `op`. Its new ids must be unused, and a split must not create a tetrahedron without volume.
  void apply(const TopologyOp& op);
  /// Undoes the last operation still in force; content_hash() then returns its previous value.
  void take_back(const TopologyOp& op);
  /// Defers the masses of tetrahedra's nodes to settle_masses(). Masses are sums over the tetrahedra at a
  /// node; deferring computes them once instead of after each change. Until then the masses of changed nodes
  /// are stale.
  void defer_masses() { masses_.defer(); }
  void settle_masses() { masses_.settle(tables_); }
  /// Continues an earlier state of the same body after `later`: ids that were used in `later` are not reused.
  void continue_from(const TetComplex& later);

 private:
  TetComplex(TetTables tables, NodeMasses masses);

  TetTables tables_;
  NodeMasses masses_;
  EdgeScratch scratch_;
  std::uint64_t undone_ = 0;
};

/// Returns a hash of connectivity, rest shape and masses, by id.
std::uint64_t content_hash(const TetComplex& complex);
/// Returns the ids of live nodes, or tetrahedra, ascending.
std::vector<NodeId> node_ids(const TetComplex& complex);
std::vector<TetId> tet_ids(const TetComplex& complex);

inline bool has_corner(const TetComplex& complex, TetId tet, NodeId node) {
  return complex.corner_index(tet, node) < 4;
}

}  // namespace prosector
