#pragma once
// Isosurface stuffing (Labelle & Shewchuk, SIGGRAPH 2007): tetrahedra of guaranteed shape from any field.

#include "common/anatomy/field.h"
#include "common/anatomy/mesh_quality.h"
#include "common/mesh.h"

namespace prosector {

/// Fills the solid in one pass on a uniform body-centred cubic lattice. `cell` is the lattice's short edge
/// (metres), so interior edges are cell and 1.155 cell long and a tetrahedron has 0.128 cell³. `offset`
/// shifts the lattice, in lattice constants. Dihedral angles are at least 10.7° where the zero set is met
/// once along each lattice edge. Throws InputError when the lattice would have more than 10 million points.
TetMesh stuff(const SolidField& field, double cell, const Vec3& offset);

inline constexpr double max_tets = 2e6;  // of one solid: what can be stepped and sent at all

/// Estimates, in a millisecond, how many tetrahedra `stuff` gives, from the solid's volume as sampled.
double expected_tets(const SolidField& field, double cell);

/// Returns the largest piece of `stuff`, with a manifold boundary. Tries lattice offsets, then slightly
/// smaller cells, and keeps the best; vertices at which pieces only touch are then split. Throws InputError,
/// with a cell that is allowed, when the cell is too coarse for the shape or needs more than `max_tets`. The
/// latter is found before anything is made.
TetMesh stuff_solid(const SolidField& field, double cell);

}  // namespace prosector
