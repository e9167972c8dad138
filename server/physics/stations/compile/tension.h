#pragma once
// Residual tension of an organ's outermost layer.

#include <vector>

#include "common/mesh.h"
#include "common/scene/scene.h"

namespace prosector {

/// Returns V (rest_stretch.h) of each tetrahedron. Without stress, the outermost `depth` m would be smaller
/// by `strain` along the nearest surface. So V is 1/(1 − strain) along the surface there, and 1 across it and
/// below. A tetrahedron that is partially deeper has the mean.
std::vector<Mat3> layer_stretch(const TetMesh& mesh, double strain, double depth);

/// Sets the tension described in `desc` on the body's tetrahedra, in balance (balanced_stretch.h). Edge nodes
/// are not allowed. Does nothing without tension, and for sheets, whose springs are shortened instead.
/// Returns by how far the remaining imbalance would move a node, m. Throws InputError for a rope.
double put_under_tension(const SoftDesc& desc, Anatomy& anatomy);

}  // namespace prosector
