#pragma once
// Least-squares fit of a tetrahedral mesh's boundary to a solid's surface.

#include "common/anatomy/field.h"
#include "common/mesh.h"

namespace prosector {

/// Moves the boundary nodes of a mesh of tetrahedra of about `cell` m, so that the mean squared distance
/// between boundary faces and the field's zero set is least. A mesh whose nodes lie on the surface cuts off
/// the solid's convex parts. After the fit, faces deviate to both sides, and the volume is the solid's up to
/// second order. Nodes near sharp edges and corners move towards them. Dihedral angles outside of 17° to
/// 147° do not become worse, and others stay inside.
void fit_boundary(const SolidField& field, double cell, TetMesh& mesh);

}  // namespace prosector
