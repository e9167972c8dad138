#pragma once
// A complex of tetrahedra, or of a sheet's triangles, that can be cut: who neighbours whom, kept up to date
// locally. It knows the rest shape only; positions of the moving body are the caller's, by node id. What is
// said of tetrahedra and their faces holds for triangles and their edges, but for masses (sheet_mass.h).
//
// Its data are tet_tables.h and node_masses.h, its changes topology_edits.h.

#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh.h"
#include "server/physics/cutting/node_masses.h"
#include "server/physics/cutting/tet_tables.h"
#include "server/physics/cutting/topology_edits.h"
#include "server/physics/cutting/topology_op.h"

namespace prosector {

class TetComplex {
 public:
  using Corners = TetTables::Corners;
  using Origin = TetTables::Origin;
  static constexpr TetId none = TetTables::none;
  static constexpr const auto& face = TetTables::face;

  /// Takes tetrahedra of positive volume, at most two at a face. `density`: kg/m³. Throws InputError that
  /// names the tetrahedron otherwise.
  TetComplex(const TetMesh& rest, double density);
  /// Takes a sheet that was never cut, see tables_of_sheet(). `held`: by node, what is tied to its place;
  /// empty: nothing.
  static TetComplex of_sheet(const Anatomy& sheet, double density, std::vector<std::uint8_t> held);

  // ---- Queries by id. Ids of nodes and tetrahedra that are gone stay unused.
  std::size_t node_end() const { return tables_.rest.size(); }  // one past the largest id ever used
  std::size_t tet_end() const { return tables_.tet.size(); }
  std::size_t nodes() const { return tables_.live_nodes; }
  std::size_t tets() const { return tables_.live_tets; }
  bool has_node(NodeId node) const { return tables_.has_node(node); }
  bool has_tet(TetId tet) const { return tables_.has_tet(tet); }
  const Vec3& rest(NodeId node) const { return tables_.rest[node]; }             // m
  double mass(NodeId node) const { return masses_.of(node); }                    // kg
  bool is_held(NodeId node) const { return masses_.is_held(node); }              // of sheets
  std::span<const TetId> star(NodeId node) const { return tables_.star[node]; }  // ascending
  bool is_sheet() const { return tables_.is_sheet(); }
  std::size_t sides() const { return tables_.sides; }  // of one tetrahedron: 4, or 3 of triangles
  /// Returns the ids of the `sides()` corners; also of a tetrahedron that was split.
  std::span<const NodeId> corners(TetId tet) const { return tables_.corners(tet); }
  /// Returns which corner of the tetrahedron the node is; 4: none.
  std::size_t corner_index(TetId tet, NodeId node) const { return tables_.corner_index(tet, node); }
  double volume(TetId tet) const { return tables_.tet[tet].volume; }  // m³ at rest
  /// Returns the tetrahedron across the face opposite corner k; none at the boundary.
  TetId neighbor(TetId tet, std::size_t k) const { return tables_.tet[tet].beyond[k]; }
  /// Returns whether a cut made the face opposite corner k.
  bool is_wall(TetId tet, std::size_t k) const { return (tables_.tet[tet].wall >> k & 1) != 0; }
  const Lineage& lineage(TetId tet) const { return tables_.tet[tet].lineage; }
  double density() const { return masses_.density(); }  // kg/m³
  std::uint64_t undone() const { return undone_; }      // how often something was taken back
  const TetTables& tables() const { return tables_; }

  // ---- Changes. apply() and take_back() throw InputError, and change nothing, for what doesn't fit.
  /// Applies `op`. Ids that it brings must be unused; splitting makes no tetrahedron without volume.
  void apply(const TopologyOp& op);
  /// Undoes the operation that was applied last of those not yet taken back: content_hash() is then what it
  /// was.
  void take_back(const TopologyOp& op);
  /// Postpones masses of tetrahedra's nodes to settle_masses(): they are sums over stars, found once rather
  /// than after each change. Until then those of what changed are stale.
  void defer_masses() { masses_.defer(); }
  void settle_masses() { masses_.settle(tables_); }
  /// Lets the same body's earlier state go on where `later` was: ids that were used there are used.
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
