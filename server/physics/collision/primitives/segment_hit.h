#pragma once
// Where a segment goes through a triangle.

#include <optional>

#include "server/physics/collision/primitives/closest_points.h"

namespace prosector {

struct SegmentHit {
  double t;      // along the segment
  Vec3 weights;  // of the triangle's corners
};

/// Returns where the segment a–b goes through the triangle; none where both lie in one plane. `slack`: as
/// much may a weight be below 0, so that nothing slips through between two triangles that share an edge.
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

}  // namespace prosector
