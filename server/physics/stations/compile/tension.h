#pragma once
// Residual tension of an organ's outermost layer.

#include <vector>

#include "common/mesh.h"
#include "common/scene/scene.h"

namespace prosector {

/// Returns the rest stretch V (3 × 3) of each tetrahedron for a body whose outermost layer, `depth` m thick,
/// is under tension. Without stress, the layer would be smaller by the fraction `strain` along the nearest
/// surface. So V is 1/(1 − strain) along the surface in the layer, and 1 across the surface and below the
/// layer. A tetrahedron that is partially in the layer has the mean.
std::vector<Mat3> layer_stretch(const TetMesh& mesh, double strain, double depth);

/// Sets the residual tension that `desc` describes on the body's tetrahedra, in balance (balanced_stretch.h).
/// Edge nodes (of quadratic elements) are not allowed. Does nothing without tension, and for sheets, whose
/// springs are shortened instead. Returns by how far the remaining imbalance would move a node, m. Throws
/// InputError for a rope.
double put_under_tension(const SoftDesc& desc, Anatomy& anatomy);

}  // namespace prosector
