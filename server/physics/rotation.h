#pragma once
// Rotation vectors: axis times angle, rad.

#include "common/math.h"

namespace prosector {

/// Returns the shortest rotation vector that leads from a to b, world frame.
inline Vec3 turn(const Quat& a, const Quat& b) {
  Quat q = b * a.conjugate();
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  const Eigen::AngleAxisd rotation(q);
  return rotation.angle() * rotation.axis();
}

}  // namespace prosector
