#pragma once
// How good the shape of a tetrahedron or a triangle is.

#include <array>

#include "common/math.h"

namespace prosector {

/// Returns the cosine of the least of the six dihedral angles; 1 for flat tetrahedra.
double cos_least_dihedral(const std::array<Vec3, 4>& x);

/// Returns the cosine of the least of a triangle's three angles; 1 for flat ones.
double cos_least_angle(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace prosector
