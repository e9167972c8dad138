#pragma once
// Quadrature points of a surface triangle for contact that is integrated over its area.
//
// Flat bodies press a triangle evenly. On linear elements the corners carry this load, a third of the area
// each. Otherwise each corner has a twelfth of the area and the centroid the rest. That rule is exact for
// quadratic functions. Neighbours share corners, so the rule needs three points per vertex of the mesh. A
// body whose radius is comparable to the triangle does not press the whole triangle: there the same rule is
// applied to its four quarters, or to their quarters.

#include <span>

#include "common/mesh.h"

namespace prosector::contact {

struct AreaPoint {
  Vec3 weights = Vec3::Zero();  // barycentric
  double share = 0;             // fraction of the triangle's area
};

/// Division of a surface triangle into quadrature points for contact that is integrated over its area.
/// `corners`: points at the corners only. `whole`: corners and centroid. `quarters`, `sixteenths`: corners
/// and centroids of the triangle's four or sixteen equal parts.
enum class Division { corners, whole, quarters, sixteenths };

inline constexpr std::uint32_t most_face_points = 36;  // number of points off the corners, of all divisions

/// Returns the division into quadrature points for a triangle of area `area` (m²) that a body presses.
/// `curvature`, 1/m: sum of the body's principal curvatures at the contact, 0 for a flat body. `quadratic`:
/// whether the tissue's elements are quadratic.
Division division_for(double area, double curvature, bool quadratic);
/// Returns the fraction of the triangle's area that each of its three corners represents as a quadrature
/// point under this division.
double corner_share(Division division);
/// Returns the quadrature points that a pressed triangle has under this division, without those at its
/// corners. Division::corners has no others.
std::span<const AreaPoint> face_points(Division division);
/// Returns the offset of this division's points in the numbering of all points off the corners. `whole` has
/// point 0, `quarters` has points 1 to 7, `sixteenths` all others, so that indices of different points
/// differ.
std::uint32_t first_face_point(Division division);
/// Returns the barycentric weights of the seven quadrature points of the division `quarters` that are not
/// corners of the triangle. `quarters` divides a triangle into four of equal size; the last point is the
/// triangle's centroid.
std::span<const Vec3> places_on_quarters();

}  // namespace prosector::contact
