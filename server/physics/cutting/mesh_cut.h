#pragma once
// Cuts tetrahedra, or a sheet's triangles, along the surface that a blade's edge sweeps
// (docs/decisions/0009).
//
// Edges that the sweep crosses are bisected one by one, longest first. Where that would make a tetrahedron
// with a dihedral angle below the floor, the nearer end counts as lying on the blade instead. Nodes never
// move, so the rest shape, its volume and mass stay. Faces whose three nodes lie on the blade, between
// tetrahedra on different sides of it, become double; nodes whose tetrahedra then fall apart are parted.

#include <span>
#include <vector>

#include "server/physics/cutting/blade_stroke.h"
#include "server/physics/cutting/tet_complex.h"
#include "server/physics/cutting/tet_tree.h"

namespace prosector {

/// No cut makes a smaller dihedral angle, or angle of a triangle; smaller ones that a mesh had are not made
/// smaller.
inline constexpr double least_dihedral_deg = 5;
/// Edges are not split into pieces shorter than this times TetComplex::cell(), so that strokes without end
/// make no elements without end.
inline constexpr double least_edge_share = 0.1;
/// Nothing smaller comes free; of the compiled mesh's mean tetrahedron.
inline constexpr double least_piece_share = 0.15;

struct CutResult {
  std::vector<TopologyOp> ops;  // already applied, in order
  std::size_t split_edges = 0, split_tets = 0, slit_faces = 0, parted_nodes = 0;
  std::size_t snapped = 0;          // nodes taken as lying on the blade that weren't quite
  double farthest_snap = 0;         // m: of them from the blade, at rest
  double least_dihedral_deg = 180;  // of the tetrahedra made
  std::size_t slivers = 0;          // of them below the floor, because they were before
};

/// Makes one tick of the stroke: from where its edge was, carried along by the tissue, to `edge`.
/// `positions`: m, by node id, at least node_end() of them. Throws InputError, and changes nothing, for
/// another number of points than the stroke's, numbers that aren't finite, too few positions.
CutResult cut(TetComplex& complex, TetTree& tree, std::span<const Vec3> positions, std::span<const Vec3> edge,
              BladeStroke& stroke);

}  // namespace prosector
