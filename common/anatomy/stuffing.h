#pragma once
// Isosurface stuffing (Labelle & Shewchuk, SIGGRAPH 2007): tetrahedral meshing of a field with bounded
// dihedral angles.

#include "common/anatomy/field.h"
#include "common/anatomy/mesh_quality.h"
#include "common/mesh.h"

namespace prosector {

/// Fills the solid with tetrahedra in one pass on a uniform body-centred cubic lattice. `cell` is the
/// lattice's short edge (metres), so interior edges are cell and 1.155 cell long and a tetrahedron's volume
/// is 0.128 cell³. `offset` shifts the lattice, in lattice constants. Dihedral angles are at least 10.7° if
/// the zero set crosses each lattice edge at most once. Throws InputError if the lattice would have more than
/// 10 million points.
TetMesh stuff(const SolidField& field, double cell, const Vec3& offset);

inline constexpr double max_tets = 2e6;  // of one solid: limit of what can be simulated and sent

/// Estimates, in about a millisecond, the number of tetrahedra that stuff() makes with the short lattice edge
/// `cell` (m), from the solid's sampled volume.
double expected_tets(const SolidField& field, double cell);

/// Fills the solid with tetrahedra of about `cell` m, and returns the largest piece with a manifold boundary.
/// Tries several lattice offsets, then slightly smaller cells, and keeps the best mesh. Vertices at which
/// pieces only touch are then split, and the boundary is fitted to the surface (fit_boundary). Throws
/// InputError, with an allowed cell, if the cell is too coarse for the shape or needs more than `max_tets`.
/// The latter is checked before meshing.
TetMesh stuff_solid(const SolidField& field, double cell);

}  // namespace prosector
