#pragma once
// Whether two triangles cross, and where.

#include <array>
#include <cstddef>
#include <cstdint>

#include "server/physics/collision/primitives/closest_points.h"

namespace prosector {

/// Where an edge of one triangle goes through the other.
struct Piercing {
  bool of_a = true;       // whose edge
  std::uint8_t edge = 0;  // from corner `edge` to corner (edge + 1) % 3
  double along = 0;       // of the edge, in [0, 1]
  Vec3 point = Vec3::Zero();
};

struct TriangleCrossing {
  bool crosses = false;
  std::size_t count = 0;  // 0 too where triangles of one plane overlap
  std::array<Piercing, 6> piercings;
};

/// Tells whether and where closed triangles cross; touching counts. As in Möller 1997 ("A fast
/// triangle-triangle intersection test"), planes come first. Then come edges against faces, which says where,
/// and leaves no case out that has a length. Triangles in one plane, and those without an area, cross where
/// their distance is less than rounding. The result is equal but for `of_a` when a and b are swapped.
TriangleCrossing crossing(const Triangle& a, const Triangle& b);

}  // namespace prosector
