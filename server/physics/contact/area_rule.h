#pragma once
// The points of a surface triangle that stand for its area where something presses it.
//
// What is flat presses it evenly: on linear elements its corners do, with a third of the area each. Elsewhere
// they have a twelfth each and its middle the rest. That integrates quadratic functions
// exactly, and since neighbours share corners it takes three points a vertex of the mesh. What is round on
// the scale of the triangle presses less than all of it: there the same rule is used on its four quarters.

#include <span>

#include "common/mesh.h"

namespace prosector {

struct AreaPoint {
  Vec3 weights = Vec3::Zero();  // of the triangle's corners
  double share = 0;             // of its area
};

/// How a triangle is divided: not at all, its corners do; as a whole; in its quarters.
enum class Division { corners, whole, quarters };

inline constexpr std::uint32_t most_face_points = 8;  // of both divisions, but for the corners

/// Returns the division for a triangle of so much area (m²) under a thing of that curvature (1/m).
/// `quadratic`: whether the elements are.
Division division_for(double area, double curvature, bool quadratic);
/// Returns the share of the triangle's area that each of its corners has.
double corner_share(Division division);
/// Returns the points off the corners.
std::span<const AreaPoint> face_points(Division division);
/// Returns the number of the first of them among all of a triangle's, so that each is known by its own.
std::uint32_t first_face_point(Division division);
/// Returns the weights of those of the quarters.
std::span<const Vec3> places_on_quarters();

}  // namespace prosector
