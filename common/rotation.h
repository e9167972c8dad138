#pragma once
// Rotation vectors: axis times angle, rad.

#include "common/math.h"

namespace prosector {

/// Returns the shortest rotation vector (axis times angle, rad) that rotates orientation a to orientation b,
/// in the world frame.
inline Vec3 turn(const Quat& a, const Quat& b) {
  Quat q = b * a.conjugate();
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  const Eigen::AngleAxisd rotation(q);
  return rotation.angle() * rotation.axis();
}

/// Returns the rotation that corresponds to a rotation vector (axis times angle, rad), by the exponential
/// map.
inline Quat rotated_by(const Vec3& vector) {
  const double angle = vector.norm();
  return angle > 0 ? Quat(Eigen::AngleAxisd(angle, vector / angle)) : Quat::Identity();
}

}  // namespace prosector
