#pragma once
// Intersection of two triangles.

#include <array>
#include <cstddef>
#include <cstdint>

#include "server/physics/mechanics/collision/primitives/closest_points.h"

namespace prosector::collision {

/// Point at which an edge of one triangle crosses the other triangle, when triangles a and b intersect.
struct Piercing {
  bool of_a = true;       // whether the edge belongs to a
  std::uint8_t edge = 0;  // from corner `edge` to corner (edge + 1) % 3
  double along = 0;       // position on the edge, in [0, 1]
  Vec3 point = Vec3::Zero();
};

struct TriangleCrossing {
  bool crosses = false;
  std::size_t count = 0;  // also 0 if coplanar triangles overlap
  std::array<Piercing, 6> piercings;
};

/// Returns whether two triangles, edges included, intersect, and at which points; touching triangles
/// intersect. Planes are tested first, as in Möller 1997 ("A fast triangle-triangle intersection test"). Then
/// edges are tested against faces, which gives the intersection points and covers every intersection that has
/// a length. Coplanar triangles, and triangles without area, intersect if their distance is below rounding.
/// Swapping a and b changes only `of_a` and the order of the points.
TriangleCrossing crossing(const Triangle& a, const Triangle& b);

}  // namespace prosector::collision
