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

namespace prosector::cutting {

class TetComplex {
 public:
  using Corners = TetTables::Corners;
  using Origin = TetTables::Origin;
  static constexpr TetId none = TetTables::none;
  static constexpr const auto& face = TetTables::face;

  /// Builds the complex of an uncut body from tetrahedra of positive volume, at most two at each face;
  /// `density` in kg/m³. Throws InputError for other input; the message names the invalid tetrahedron.
  TetComplex(const TetMesh& rest, double density);
  /// Creates the complex of an uncut sheet from its cells, each of which becomes two triangles
  /// (tables_of_sheet()). `held`: for each node, 1 if it is fixed in position; empty if no node is. `density`
  /// in kg/m³.
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
  /// Returns the node ids of the tetrahedron's corners: four, or three for a triangle of a sheet. They are
  /// also valid for a tetrahedron that was split.
  std::span<const NodeId> corners(TetId tet) const { return tables_.corners(tet); }
  /// Returns the index of the node among the tetrahedron's corners; 4 if the node is not a corner.
  std::size_t corner_index(TetId tet, NodeId node) const { return tables_.corner_index(tet, node); }
  double volume(TetId tet) const { return tables_.tet[tet].volume; }  // m³, in the rest shape
  /// Returns the id of the neighbouring tetrahedron across the face opposite corner k; `none` if the face is
  /// on the boundary.
  TetId neighbor(TetId tet, std::size_t k) const { return tables_.tet[tet].beyond[k]; }
  /// Returns whether the tetrahedron's face opposite corner k is a wall of a cut: a boundary face that a cut
  /// created.
  bool is_wall(TetId tet, std::size_t k) const { return (tables_.tet[tet].wall >> k & 1) != 0; }
  const Lineage& lineage(TetId tet) const { return tables_.tet[tet].lineage; }
  double density() const { return masses_.density(); }  // kg/m³
  std::uint64_t undone() const { return undone_; }      // number of operations taken back
  const TetTables& tables() const { return tables_; }

  // ---- Changes. For an invalid operation, apply() and take_back() throw InputError and change nothing.
  /// Applies a topology change and updates connectivity and masses. Throws InputError, and changes nothing,
  /// if its new ids are in use, it does not match the mesh, or a split would create a tetrahedron without
  /// volume.
  void apply(const TopologyOp& op);
  /// Undoes a topology change, which must be the last one that was not undone. content_hash() then returns
  /// its previous value. Throws InputError, and changes nothing, if the change does not match the mesh.
  void take_back(const TopologyOp& op);
  /// Postpones the masses of nodes of tetrahedra until settle_masses() is called. A mass is a sum over the
  /// tetrahedra at a node; postponing computes it once instead of after each change. Until then the masses of
  /// changed nodes are outdated.
  void defer_masses() { masses_.defer(); }
  void settle_masses() { masses_.settle(tables_); }
  /// Makes this complex, an earlier state of the same body, the successor of the state `later`, as after a
  /// rewind. Ids that were used in `later` are not used again.
  void continue_from(const TetComplex& later);

 private:
  TetComplex(TetTables tables, NodeMasses masses);

  TetTables tables_;
  NodeMasses masses_;
  EdgeScratch scratch_;
  std::uint64_t undone_ = 0;
};

/// Returns a hash of the complex: connectivity, rest shape, density and masses of all nodes and tetrahedra,
/// with their ids.
std::uint64_t content_hash(const TetComplex& complex);
/// Returns the ids of all nodes that exist (not removed), ascending. tet_ids() does the same for tetrahedra.
std::vector<NodeId> node_ids(const TetComplex& complex);
std::vector<TetId> tet_ids(const TetComplex& complex);

inline bool has_corner(const TetComplex& complex, TetId tet, NodeId node) {
  return complex.corner_index(tet, node) < 4;
}

}  // namespace prosector::cutting
