#pragma once
// Cutting of tetrahedra, or of a sheet's triangles, along the surface swept by a blade's edge
// (docs/decisions/0009).
//
// Edges that cross the swept surface are bisected one by one, longest first. If that would create a dihedral
// angle below the limit, the nearer end counts as lying on the blade instead. Nodes never move, so the rest
// shape, its volume and its mass are kept. Faces with three nodes on the blade, between tetrahedra on
// different sides of the blade, are duplicated. Nodes whose tetrahedra are then no longer connected through
// faces are duplicated too.

#include <span>
#include <vector>

#include "server/physics/mechanics/cutting/blade_stroke.h"
#include "server/physics/mechanics/cutting/tet_complex.h"
#include "server/physics/mechanics/cutting/tet_tree.h"

namespace prosector::cutting {

/// Smallest dihedral angle of a tetrahedron (or angle of a sheet's triangle), in degrees, that a cut may
/// create. Smaller angles that the mesh had before are not reduced.
inline constexpr double least_dihedral_deg = 5;
/// Smallest edge length that a cut may create, as a fraction of TetTables::cell, the edge length of a mean
/// element. It bounds the number of elements of a long stroke.
inline constexpr double least_edge_share = 0.1;
/// Smallest volume of a piece that a cut may detach, as a fraction of the mean tetrahedron volume of the
/// compiled mesh.
inline constexpr double least_piece_share = 0.15;

struct CutResult {
  std::vector<TopologyOp> ops;  // already applied, in this order
  std::size_t split_edges = 0, split_tets = 0, slit_faces = 0, parted_nodes = 0;
  std::size_t snapped = 0;          // nodes that count as lying on the blade but do not lie exactly on it
  double farthest_snap = 0;         // m: largest distance of these nodes from the blade, in the rest shape
  double least_dihedral_deg = 180;  // degrees, of the new tetrahedra
  std::size_t slivers = 0;          // new tetrahedra below the limit, because their parents were
};

/// Cuts the body's mesh along the surface that the blade swept in one tick. The surface extends from the
/// stroke's stored line, which the tissue carried along, to the blade's edge `edge` (m, world frame). Updates
/// `tree` and `stroke`, and returns the applied operations. `positions`: current node positions, m, by node
/// id, at least node_end() values.
///
/// Throws InputError, and changes nothing, if `edge` has another number of points than the stroke, for
/// numbers that are not finite, or for too few positions.
CutResult cut(TetComplex& complex, TetTree& tree, std::span<const Vec3> positions, std::span<const Vec3> edge,
              BladeStroke& stroke);

}  // namespace prosector::cutting
