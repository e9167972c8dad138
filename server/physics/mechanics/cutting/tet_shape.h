#pragma once
// Shape quality of tetrahedra and triangles.

#include <array>

#include "common/math.h"

namespace prosector::cutting {

/// Returns the cosine of the smallest of a tetrahedron's six dihedral angles; 1 for a flat tetrahedron. `x`:
/// its corners.
double cos_least_dihedral(const std::array<Vec3, 4>& x);

/// Returns the cosine of the smallest of the three angles of triangle abc; 1 if two corners coincide.
double cos_least_angle(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace prosector::cutting
