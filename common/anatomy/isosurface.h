#pragma once
// The zero set of a solid's field as a triangle surface: what is touched and drawn.

#include "common/anatomy/field.h"
#include "common/mesh.h"

namespace prosector {

/// Makes the surface by marching tetrahedra on a BCC lattice (always a closed manifold). Short edges are
/// collapsed and vertices relaxed along the surface until edges are about `cell` metres long. Only the
/// largest piece is kept. Throws InputError when there is no surface.
TriangleMesh isosurface(const SolidField& field, double cell);

/// Returns the piece with the largest enclosed volume.
TriangleMesh largest_piece(const TriangleMesh& mesh);

}  // namespace prosector
