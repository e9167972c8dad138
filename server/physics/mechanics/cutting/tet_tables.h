#pragma once
// Tables of a complex of tetrahedra or triangles, by id: connectivity, rest shape and lineage, as plain data.
// The operations in topology_edits.h keep the tables consistent.

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "common/mesh.h"
#include "server/physics/mechanics/cutting/topology_op.h"

namespace prosector::cutting {

/// Parent and children of a tetrahedron: a split replaces a tetrahedron by two children.
struct Lineage {
  static constexpr TetId none = std::numeric_limits<TetId>::max();
  TetId parent = none;  // none: a tetrahedron of the compiled mesh
  TetId child = none;   // first of its two children; the second has the next id; none: not split
  /// Sort key of the tetrahedron, which a cut does not change. When a tetrahedron is split, its first child
  /// inherits the key, and the second child's key is its own id. Keys of live tetrahedra are unique.
  TetId place = none;
};

struct TetTables {
  static constexpr TetId none = Lineage::none;
  using Corners = std::array<NodeId, 4>;
  /// For each corner k of a tetrahedron, the corner indices of the face opposite k, counter-clockwise as seen
  /// from outside.
  static constexpr std::array<std::array<std::size_t, 3>, 4> face = {
      {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

  /// All data of one tetrahedron (or triangle of a sheet), stored together because a cut reads them together.
  struct Tet {
    Corners corner{};                                        // kept after a split; triangles use three
    std::array<TetId, 4> beyond = {none, none, none, none};  // by face: the neighbour
    double volume = 0;                                       // m³, in the rest shape
    Lineage lineage;
    std::uint8_t wall = 0;  // bit k: face k was created by a cut
    bool live = false;
  };
  /// Origin of a node that a cut created at a + t·(b − a), where a and b are nodes. A copy of a node has a =
  /// b = that node. A node of the compiled mesh has a = b = its own id.
  struct Origin {
    NodeId a = none, b = none;
    double t = 0;
  };

  std::size_t sides = 4;  // corners, and faces, of one tetrahedron: 4, or 3 for triangles
  double thickness = 0;   // m, of a sheet
  std::vector<Vec3> rest;
  std::vector<Origin> origin;            // also of removed nodes
  std::vector<std::uint8_t> node_live;   // by node
  std::vector<std::vector<TetId>> star;  // by node: its tetrahedra, ascending
  std::vector<Tet> tet;
  std::size_t live_nodes = 0, live_tets = 0;
  /// `mean_volume`, m³: mean volume of the compiled mesh's elements. `cell`, m: edge length of a regular
  /// element of this volume.
  double mean_volume = 0, cell = 0;

  bool is_sheet() const { return sides == 3; }
  bool has_node(NodeId node) const { return node < rest.size() && node_live[node]; }
  bool has_tet(TetId t) const { return t < tet.size() && tet[t].live; }
  std::span<const NodeId> corners(TetId t) const { return {tet[t].corner.data(), sides}; }
  /// Returns the index of the node among the corners of tetrahedron t; 4 if the node is not a corner.
  std::size_t corner_index(TetId t, NodeId node) const;
  /// Returns the index of the face of tetrahedron t whose stored neighbour is `other`; 4 if they are not
  /// neighbours.
  std::size_t face_towards(TetId t, TetId other) const;
  /// Returns the index of the face of tetrahedron t whose corners are also corners of `other`, even if they
  /// are no longer neighbours. Returns 4 if there is no such face.
  std::size_t face_shared(TetId t, TetId other) const;
  /// Sets `tets` to the ids of the tetrahedra that have both nodes a and b as corners, ascending.
  void around_edge(NodeId a, NodeId b, std::vector<TetId>& tets) const;
  /// Returns the volume, m³, of an element with corners at x (m): a tetrahedron, or a triangle of a sheet
  /// times its thickness. It is negative for an inverted tetrahedron.
  double volume_of(std::span<const Vec3> x) const;

  void grow_nodes(std::size_t end);
  void grow_tets(std::size_t end);
  /// Removes tetrahedron t from the node's star, the list of tetrahedra at the node. leave_all() removes
  /// several (ascending).
  void leave(NodeId node, TetId t);
  void leave_all(NodeId node, std::span<const TetId> tets);
  /// Inserts tetrahedron t in the node's star, the ascending list of tetrahedra at the node.
  void enter(NodeId node, TetId t);
};

/// Returns tables of an uncut tetrahedral mesh with rest positions and corners only; connect() fills in the
/// rest.
TetTables tables_of(const TetMesh& rest);
/// Returns tables of an uncut sheet with rest positions and corners only; connect() fills in the rest. Cell i
/// with corners a, b, c, d becomes triangles 2i (a, b, c) and 2i + 1 (a, c, d).
TetTables tables_of_sheet(const Anatomy& sheet);
/// Fills in the data that follow from rest positions and corners: neighbours, stars, volumes and mean size.
/// Throws InputError if a node is missing, a volume is not positive, or more than two tetrahedra share a
/// face. The message names the tetrahedron.
void connect(TetTables& tables);

}  // namespace prosector::cutting
