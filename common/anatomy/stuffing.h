#pragma once
// Isosurface stuffing (Labelle & Shewchuk, SIGGRAPH 2007): tetrahedra of guaranteed shape from any field.

#include "common/anatomy/field.h"
#include "common/anatomy/mesh_quality.h"
#include "common/mesh.h"

namespace prosector {

/// One pass on a uniform body-centred cubic lattice. `cell` is the lattice's short edge (metres), so interior
/// edges are cell and 1.155 cell long and a tetrahedron has 0.128 cell³; `offset` shifts the lattice, in
/// lattice constants. Dihedral angles are at least 10.7° where the zero set is met once along each lattice
/// edge. Throws InputError when the lattice would have more than 2^26 points.
TetMesh stuff(const SolidField& field, double cell, const Vec3& offset);

/// The largest piece of `stuff`, with a manifold boundary: tries lattice offsets, then slightly smaller
/// cells, and keeps the best; vertices at which pieces only touch are then split. Throws InputError when
/// there's nothing to mesh or the cell is too coarse for the shape.
TetMesh stuff_solid(const SolidField& field, double cell);

}  // namespace prosector
