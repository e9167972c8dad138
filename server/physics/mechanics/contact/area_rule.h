#pragma once
// Quadrature points of a surface triangle for contact that is integrated over its area.
//
// Flat bodies press a triangle evenly. On linear elements the corners carry this load, a third of the area
// each. Otherwise each corner has a twelfth of the area and the centroid the rest. That rule is exact for
// quadratic functions. Neighbours share corners, so the rule needs three points per vertex of the mesh. A
// body whose radius is comparable to the triangle does not press the whole triangle: there the same rule is
// applied to its four quarters.

#include <span>

#include "common/mesh.h"

namespace prosector {

struct AreaPoint {
  Vec3 weights = Vec3::Zero();  // barycentric
  double share = 0;             // fraction of the triangle's area
};

/// How a triangle is divided: corners only; centroid rule on the whole triangle; centroid rule on its
/// quarters.
enum class Division { corners, whole, quarters };

inline constexpr std::uint32_t most_face_points = 8;  // number of points off the corners, of both divisions

/// Returns the division for a triangle of area `area` (m²) under a body of that curvature (1/m). `quadratic`:
/// whether the elements are quadratic.
Division division_for(double area, double curvature, bool quadratic);
/// Returns the fraction of the triangle's area that each corner has.
double corner_share(Division division);
/// Returns the points that are not corners.
std::span<const AreaPoint> face_points(Division division);
/// Returns the index of the division's first point among the points of all divisions. Indices of different
/// points differ.
std::uint32_t first_face_point(Division division);
/// Returns the barycentric weights of the points of `quarters`.
std::span<const Vec3> places_on_quarters();

}  // namespace prosector
