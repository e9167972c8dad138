#pragma once
// The tables of a complex of tetrahedra or triangles, by id: connectivity, rest shape and lineage, as plain
// data. Whoever changes them keeps them consistent, see topology_edits.h.

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "common/mesh.h"
#include "server/physics/cutting/topology_op.h"

namespace prosector {

/// Which tetrahedra a tetrahedron came from and became.
struct Lineage {
  static constexpr TetId none = std::numeric_limits<TetId>::max();
  TetId parent = none;  // none: one of the compiled mesh
  TetId child = none;   // the first of the two that it became; the other is the next id; none: not split
  /// The key by which tetrahedra are ordered. The first child inherits it, the second child's is its own id.
  /// No two live tetrahedra have the same, and a cut changes no key.
  TetId place = none;
};

struct TetTables {
  static constexpr TetId none = Lineage::none;
  using Corners = std::array<NodeId, 4>;
  /// Corners of the face opposite corner k, counter-clockwise from outside.
  static constexpr std::array<std::array<std::size_t, 3>, 4> face = {
      {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

  /// All that is known of one tetrahedron, in one place: what a cut looks at it takes together.
  struct Tet {
    Corners corner{};                                        // kept when it is split; of triangles three
    std::array<TetId, 4> beyond = {none, none, none, none};  // by face: the neighbour
    double volume = 0;                                       // m³ at rest
    Lineage lineage;
    std::uint8_t wall = 0;  // bit k: a cut made face k
    bool live = false;
  };
  /// Where a cut put a node: at a + t·(b − a). A copy has a = b, which it is a copy of; a node of the
  /// compiled mesh names itself.
  struct Origin {
    NodeId a = none, b = none;
    double t = 0;
  };

  std::size_t sides = 4;  // corners, and faces, of one: 4, or 3 of triangles
  double thickness = 0;   // m, of a sheet
  std::vector<Vec3> rest;
  std::vector<Origin> origin;            // gone nodes too
  std::vector<std::uint8_t> node_live;   // by node
  std::vector<std::vector<TetId>> star;  // by node: its tetrahedra, ascending
  std::vector<Tet> tet;
  std::size_t live_nodes = 0, live_tets = 0;
  double mean_volume = 0, cell = 0;  // m³, of the compiled mesh; m, edge of a regular one of that size

  bool is_sheet() const { return sides == 3; }
  bool has_node(NodeId node) const { return node < rest.size() && node_live[node]; }
  bool has_tet(TetId t) const { return t < tet.size() && tet[t].live; }
  std::span<const NodeId> corners(TetId t) const { return {tet[t].corner.data(), sides}; }
  /// Returns which corner of t the node is; 4: none.
  std::size_t corner_index(TetId t, NodeId node) const;
  /// Returns the face of t towards its neighbour `other`; 4: none.
  std::size_t face_towards(TetId t, TetId other) const;
  /// Returns the face of t whose corners `other` has too; 4: none.
  std::size_t face_shared(TetId t, TetId other) const;
  /// Fills `tets` with those that have both nodes, ascending.
  void around_edge(NodeId a, NodeId b, std::vector<TetId>& tets) const;
  /// Returns what corners at x (m) enclose, m³; negative: inside out.
  double volume_of(std::span<const Vec3> x) const;

  void grow_nodes(std::size_t end);
  void grow_tets(std::size_t end);
  /// Takes a tetrahedron, or several (ascending), out of the node's star.
  void leave(NodeId node, TetId t);
  void leave_all(NodeId node, std::span<const TetId> tets);
  /// Puts a tetrahedron into the node's star.
  void enter(NodeId node, TetId t);
};

/// Returns the tables of a mesh that was never cut, with rest positions and corners alone.
TetTables tables_of(const TetMesh& rest);
/// Returns the same for a sheet: cell i with corners a, b, c, d becomes triangles 2i (a, b, c) and 2i + 1
/// (a, c, d).
TetTables tables_of_sheet(const Anatomy& sheet);
/// Fills in what follows from rest positions and corners. Throws InputError that names the tetrahedron where
/// a node is missing, a volume is not positive or more than two have one face.
void connect(TetTables& tables);

}  // namespace prosector
