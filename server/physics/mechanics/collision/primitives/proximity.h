#pragma once
// Distance or penetration depth of two shapes.

#include <cstdint>
#include <utility>

#include "common/math.h"

namespace prosector::collision {

/// Point that moves with a triangle surface, given by a triangle and barycentric weights.
struct SurfacePoint {
  static constexpr std::uint32_t none = ~0u;
  std::uint32_t triangle = none;  // none: the shape has no triangles
  Vec3 weights = Vec3::Zero();    // barycentric, of the triangle's corners
};

/// Signed distance of two shapes a and b, with normal and closest or deepest points. Moving a by −gap along
/// the normal brings the shapes just into contact at these points. on_a − on_b = gap · normal.
struct Proximity {
  Vec3 normal = Vec3::UnitY();                    // unit, from b to a
  double gap = 0;                                 // m, negative: penetration depth
  Vec3 on_a = Vec3::Zero(), on_b = Vec3::Zero();  // m, on the surface of each shape
  SurfacePoint at_a, at_b;

  Vec3 point() const { return (on_a + on_b) / 2; }
  Proximity flipped() const { return {-normal, gap, on_b, on_a, at_b, at_a}; }
};

/// Returns the proximity (gap, normal and closest points) that results when both shapes are offset outwards
/// by their rounding radii, m.
inline Proximity rounded(Proximity p, double rounding_a, double rounding_b) {
  p.gap -= rounding_a + rounding_b;
  p.on_a -= rounding_a * p.normal;
  p.on_b += rounding_b * p.normal;
  return p;
}

}  // namespace prosector::collision
