#pragma once
// Intersection of a segment and a triangle.

#include <optional>

#include "server/physics/mechanics/collision/primitives/closest_points.h"

namespace prosector::collision {

struct SegmentHit {
  double t;      // position along the segment, in [0, 1]
  Vec3 weights;  // barycentric, of the triangle's corners
};

/// Returns the intersection of the segment a–b and a triangle; empty if they do not meet, or if the segment
/// lies in the triangle's plane. Barycentric weights may be as low as −`slack`, so that no segment passes
/// between two triangles with a common edge.
inline std::optional<SegmentHit> segment_hit(const Vec3& a, const Vec3& b, const Triangle& x,
                                             double slack = 0) {
  const Vec3 n = (x[1] - x[0]).cross(x[2] - x[0]);
  const double da = n.dot(a - x[0]), db = n.dot(b - x[0]);
  if (da * db > 0 || da == db) return std::nullopt;
  const double t = da / (da - db);
  const Vec3 r = a + t * (b - a) - x[0];
  const double v = r.cross(x[2] - x[0]).dot(n) / n.squaredNorm(),
               w = (x[1] - x[0]).cross(r).dot(n) / n.squaredNorm();
  if (!(v >= -slack && w >= -slack && v + w <= 1 + slack)) return std::nullopt;
  return SegmentHit{t, {1 - v - w, v, w}};
}

}  // namespace prosector::collision
