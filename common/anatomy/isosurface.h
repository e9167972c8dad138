#pragma once
// Extraction of a solid's zero set as a triangle surface, which is drawn and used for contact.

#include "common/anatomy/field.h"
#include "common/mesh.h"

namespace prosector {

/// Extracts the surface of the solid by marching tetrahedra on a BCC lattice; the result is a closed
/// manifold. Then collapses short edges and relaxes vertices along the surface until edges are about `cell`
/// metres long. Keeps the largest piece only. Throws InputError if there is no surface.
TriangleMesh isosurface(const SolidField& field, double cell);

/// Returns the connected piece of the mesh with the largest enclosed volume.
TriangleMesh largest_piece(const TriangleMesh& mesh);

}  // namespace prosector
