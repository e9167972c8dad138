#pragma once
// Residual tension of an organ's outermost layer.

#include <vector>

#include "common/mesh.h"
#include "common/scene/scene.h"

namespace prosector {

/// Returns V (rest_stretch.h) of each tetrahedron. By themselves the outermost `depth` m would be smaller by
/// `strain` along the nearest surface. So V is 1/(1 − strain) along it there, 1 across it and below. A
/// tetrahedron partly as deep has the mean of its parts.
std::vector<Mat3> layer_stretch(const TetMesh& mesh, double strain, double depth);

/// Puts the body's tetrahedra, of which none has a node on an edge, under the tension that `desc` asks for,
/// in balance (balanced_stretch.h). Does nothing where it asks for none, and to sheets, whose springs are
/// made shorter. Returns how far what is left unbalanced would move a node, m. Throws InputError for a rope.
double put_under_tension(const SoftDesc& desc, Anatomy& anatomy);

}  // namespace prosector
