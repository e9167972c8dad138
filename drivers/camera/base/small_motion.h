#pragma once
// Poses with errors: small motions, their covariance, and their effect on points.

#include <cmath>

#include "common/rotation.h"

namespace prosector {

/// A small motion as six numbers: a rotation vector (rad) in some frame, followed by a translation (m) in the
/// same frame.
using SmallMotion = Eigen::Matrix<double, 6, 1>;
/// Covariance of a pose's error, expressed as a small motion: rotation vector (rad), then translation (m).
using MotionCovariance = Eigen::Matrix<double, 6, 6>;

/// Returns the pose after the small motion `by` (rotation vector, then translation), which is given in the
/// frame in which the pose is expressed.
inline Pose moved(const Pose& pose, const SmallMotion& by) {
  const Quat q = rotated_by(by.head<3>());
  return {q * pose.p + by.tail<3>(), (q * pose.q).normalized()};
}

/// Returns the small motion (rotation vector, then translation) that moves pose a to pose b. It is given in
/// the frame in which both poses are expressed.
inline SmallMotion motion_between(const Pose& a, const Pose& b) {
  SmallMotion out;
  out.head<3>() = turn(a.q, b.q);
  out.tail<3>() = b.p - rotated_by(out.head<3>()) * a.p;
  return out;
}

/// Returns the matrix whose product with a vector w is the cross product v × w.
inline Mat3 cross_matrix(const Vec3& v) {
  Mat3 out;
  out << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return out;
}

/// Returns the derivative of the position of a point at `p` with respect to a small motion of the point
/// (rotation vector, then translation).
inline Eigen::Matrix<double, 3, 6> point_jacobian(const Vec3& p) {
  Eigen::Matrix<double, 3, 6> out;
  out << -cross_matrix(p), Mat3::Identity();
  return out;
}

/// Transforms the covariance of small motions into another frame. `pose` is the pose of the covariance's
/// frame in the new frame; motions become pose · motion · pose⁻¹.
inline MotionCovariance transform_covariance(const Pose& pose, const MotionCovariance& spread) {
  MotionCovariance by = MotionCovariance::Zero();
  by.topLeftCorner<3, 3>() = by.bottomRightCorner<3, 3>() = pose.q.toRotationMatrix();
  by.bottomLeftCorner<3, 3>() = cross_matrix(pose.p) * pose.q.toRotationMatrix();
  return by * spread * by.transpose();
}

/// Returns the RMS error (m) at a point of a body whose pose has the covariance `spread`. The point (m) and
/// the covariance are given in the frame in which the pose is expressed.
inline double error_at(const MotionCovariance& spread, const Vec3& point) {
  const Eigen::Matrix<double, 3, 6> slope = point_jacobian(point);
  return std::sqrt((slope * spread * slope.transpose()).trace());
}

}  // namespace prosector
