#pragma once
// Poses with errors: small motions, their covariance, and their effect on points.

#include <cmath>

#include "common/rotation.h"

namespace prosector {

/// A rotation vector (rad) in a frame, then a translation (m) in that frame.
using SmallMotion = Eigen::Matrix<double, 6, 1>;
/// Covariance of small motions.
using MotionCovariance = Eigen::Matrix<double, 6, 6>;

/// Applies a small motion to a pose, in the frame that the pose maps into.
inline Pose moved(const Pose& pose, const SmallMotion& by) {
  const Quat q = rotated_by(by.head<3>());
  return {q * pose.p + by.tail<3>(), (q * pose.q).normalized()};
}

/// Returns the small motion from a to b, in the frame that both poses map into.
inline SmallMotion motion_between(const Pose& a, const Pose& b) {
  SmallMotion out;
  out.head<3>() = turn(a.q, b.q);
  out.tail<3>() = b.p - rotated_by(out.head<3>()) * a.p;
  return out;
}

/// Returns the cross product matrix v×.
inline Mat3 cross_matrix(const Vec3& v) {
  Mat3 out;
  out << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return out;
}

/// Returns the derivative of a point's position with respect to a small motion.
inline Eigen::Matrix<double, 3, 6> point_jacobian(const Vec3& p) {
  Eigen::Matrix<double, 3, 6> out;
  out << -cross_matrix(p), Mat3::Identity();
  return out;
}

/// Transforms a covariance into another frame. `pose` is the current frame's pose in that frame; motions
/// become pose · motion · pose⁻¹.
inline MotionCovariance transform_covariance(const Pose& pose, const MotionCovariance& spread) {
  MotionCovariance by = MotionCovariance::Zero();
  by.topLeftCorner<3, 3>() = by.bottomRightCorner<3, 3>() = pose.q.toRotationMatrix();
  by.bottomLeftCorner<3, 3>() = cross_matrix(pose.p) * pose.q.toRotationMatrix();
  return by * spread * by.transpose();
}

/// Returns the RMS error of a point's position, m.
inline double error_at(const MotionCovariance& spread, const Vec3& point) {
  const Eigen::Matrix<double, 3, 6> slope = point_jacobian(point);
  return std::sqrt((slope * spread * slope.transpose()).trace());
}

}  // namespace prosector
