#pragma once
// Vectors and poses used throughout Prosector: SI units, right-handed, y up.

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace prosector {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using VecX = Eigen::VectorXd;
using Quat = Eigen::Quaterniond;  // in files and on the wire: w, x, y, z

/// A rigid transform (position and orientation). As a frame `pose_a_b` it maps points of frame b into frame
/// a: x_a = q * x_b + p.
struct Pose {
  Vec3 p = Vec3::Zero();      // metres
  Quat q = Quat::Identity();  // unit

  Vec3 operator*(const Vec3& x) const { return q * x + p; }
  Pose operator*(const Pose& b) const { return {q * b.p + p, (q * b.q).normalized()}; }
  Pose inverse() const { return {q.conjugate() * -p, q.conjugate()}; }
};

/// An affine transform: x_a = A * x_b + p. Unlike a pose it can scale and shear.
struct Affine {
  Mat3 A = Mat3::Identity();
  Vec3 p = Vec3::Zero();  // metres

  Vec3 operator*(const Vec3& x) const { return A * x + p; }
};

inline bool is_finite(const Vec3& v) {
  return v.allFinite();
}
inline bool is_finite(const Pose& x) {
  return x.p.allFinite() && x.q.coeffs().allFinite();
}

}  // namespace prosector
