#include "drivers/camera/face/eyes_pose.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/rotation_between.h"

namespace prosector {

EyesPose estimate_eyes_pose(const DetectedFace& face, const Lens& lens, double eye_distance) {
  // A camera sees a user's right eye on the left. All directions are rotated so that the eyes' midpoint is on
  // the axis; the face's position in the image then doesn't matter.
  const Vec3 right = lens.ray(face.right_eye).normalized(), left = lens.ray(face.left_eye).normalized();
  const Quat straight = rotation_between(right + left, Vec3::UnitZ());
  const auto seen = [&](const Vec3& ray) -> Vec2 { return (straight * ray).hnormalized(); };
  const Vec2 across = seen(left) - seen(right), middle = (seen(left) + seen(right)) / 2;
  const double apart = std::max(across.norm(), 1e-6);
  const double shift = (seen(lens.ray(face.nose)) - middle).dot(across) / (apart * apart * nose_depth_ratio);
  EyesPose out;
  // The nose is nearer than the eyes, which magnifies its shift.
  const double nearer = std::max(0.5, 1 - nose_depth_ratio * apart);
  out.yaw = std::clamp(std::atan(shift * nearer), -max_yaw, max_yaw);
  out.roll = std::atan2(across.y(), across.x());
  const double depth = eye_distance * std::cos(out.yaw) / apart;
  const Quat facing(Eigen::AngleAxisd(std::numbers::pi, Vec3::UnitZ()));  // towards the camera, upright
  const Quat turned = Quat(Eigen::AngleAxisd(out.roll, Vec3::UnitZ())) *
                      Quat(Eigen::AngleAxisd(-out.yaw, Vec3::UnitY())) * facing;
  out.head.p = straight.conjugate() * (depth * Vec3(middle.x(), middle.y(), 1));
  out.head.q = (straight.conjugate() * turned).normalized();
  return out;
}

}  // namespace prosector
