#include "twins/trackers/distorted_field.h"

#include <algorithm>

namespace prosector {

Pose DistortedField::report(const Pose& truth) const {
  constexpr double reference = 0.5, nearest = 0.05;  // m: reference distance, and minimum distance, since
                                                     // metal is not a point
  const Vec3 r = truth.p - metal;
  const double d = std::max(r.norm(), nearest);
  const double near = reference / d;
  const Vec3 e = (3 * r * r.dot(moment) / (d * d) - moment) * near * near * near;
  const Vec3 rotation = turn * e;
  const double angle = rotation.norm();
  const Quat q = angle > 0 ? Quat(Eigen::AngleAxisd(angle, rotation / angle)) : Quat::Identity();
  return {truth.p + shift * e, (q * truth.q).normalized()};
}

}  // namespace prosector
