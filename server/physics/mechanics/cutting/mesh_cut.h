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

namespace prosector {

/// Minimum dihedral angle, or angle of a triangle, after a cut, degrees. Smaller angles that the mesh had
/// before are not reduced.
inline constexpr double least_dihedral_deg = 5;
/// Minimum edge length after a split, relative to TetComplex::cell(). It bounds the number of elements of a
/// long stroke.
inline constexpr double least_edge_share = 0.1;
/// Minimum volume of a piece that is cut free, relative to the mean tetrahedron of the compiled mesh.
inline constexpr double least_piece_share = 0.15;

struct CutResult {
  std::vector<TopologyOp> ops;  // already applied, in this order
  std::size_t split_edges = 0, split_tets = 0, slit_faces = 0, parted_nodes = 0;
  std::size_t snapped = 0;          // nodes that count as lying on the blade but do not lie exactly on it
  double farthest_snap = 0;         // m: largest distance of these nodes from the blade, in the rest shape
  double least_dihedral_deg = 180;  // degrees, of the new tetrahedra
  std::size_t slivers = 0;          // new tetrahedra below the limit, because their parents were
};

/// Cuts along the surface swept in one tick: from the stroke's line, carried along by the tissue, to `edge`.
/// `positions`: m, by node id, at least node_end() values. Throws InputError, and changes nothing, for a
/// number of points other than the stroke's, for numbers that are not finite, or for too few positions.
CutResult cut(TetComplex& complex, TetTree& tree, std::span<const Vec3> positions, std::span<const Vec3> edge,
              BladeStroke& stroke);

}  // namespace prosector
