#pragma once
// Shape quality of tetrahedra and triangles.

#include <array>

#include "common/math.h"

namespace prosector {

/// Returns the cosine of the smallest of the six dihedral angles; 1 for flat tetrahedra.
double cos_least_dihedral(const std::array<Vec3, 4>& x);

/// Returns the cosine of the smallest of a triangle's three angles; 1 for degenerate triangles.
double cos_least_angle(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace prosector
