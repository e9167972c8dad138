#pragma once
// How good a tetrahedron's shape is.

#include <array>

#include "common/math.h"

namespace prosector {

/// Cosine of the least of the six dihedral angles; 1 for flat tetrahedra.
double cos_least_dihedral(const std::array<Vec3, 4>& x);

}  // namespace prosector
