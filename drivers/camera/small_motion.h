#pragma once
// Poses that are known with some error: small motions of them, and what these do to points.

#include <cmath>

#include "common/rotation.h"

namespace prosector {

/// A turn (rad) about a frame's axes, then a shift (m) along them.
using SmallMotion = Eigen::Matrix<double, 6, 1>;
/// How small motions scatter: their covariance.
using MotionSpread = Eigen::Matrix<double, 6, 6>;

/// Moves a pose in the frame that it leads to.
inline Pose moved(const Pose& pose, const SmallMotion& by) {
  const Quat q = turned_by(by.head<3>());
  return {q * pose.p + by.tail<3>(), (q * pose.q).normalized()};
}

/// Returns the small motion that leads from a to b, in the frame that both lead to.
inline SmallMotion motion_between(const Pose& a, const Pose& b) {
  SmallMotion out;
  out.head<3>() = turn(a.q, b.q);
  out.tail<3>() = b.p - turned_by(out.head<3>()) * a.p;
  return out;
}

/// Returns the matrix v× of the cross product.
inline Mat3 cross_matrix(const Vec3& v) {
  Mat3 out;
  out << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return out;
}

/// Returns how a point moves by a small motion.
inline Eigen::Matrix<double, 3, 6> point_slope(const Vec3& p) {
  Eigen::Matrix<double, 3, 6> out;
  out << -cross_matrix(p), Mat3::Identity();
  return out;
}

/// Returns the spread as another frame has it, which lies in `pose`: pose · motion · pose⁻¹.
inline MotionSpread spread_in(const Pose& pose, const MotionSpread& spread) {
  MotionSpread by = MotionSpread::Zero();
  by.topLeftCorner<3, 3>() = by.bottomRightCorner<3, 3>() = pose.q.toRotationMatrix();
  by.bottomLeftCorner<3, 3>() = cross_matrix(pose.p) * pose.q.toRotationMatrix();
  return by * spread * by.transpose();
}

/// Returns the RMS error of a point, m.
inline double error_at(const MotionSpread& spread, const Vec3& point) {
  const Eigen::Matrix<double, 3, 6> slope = point_slope(point);
  return std::sqrt((slope * spread * slope.transpose()).trace());
}

}  // namespace prosector
