#include "client/view/camera.h"

#include <cmath>

namespace prosector {

Pose look_at(const Vec3& eye, const Vec3& target) {
  const Vec3 back = (eye - target).normalized();
  // With a vertical view direction, "right" is undefined: use x.
  const Vec3 right =
      std::abs(back.y()) < 0.9999 ? Vec3::UnitY().cross(back).normalized() : Vec3(Vec3::UnitX());
  Mat3 axes;
  axes << right, back.cross(right), back;
  return {eye, Quat(axes).normalized()};
}

DrawCamera mono_camera(const Pose& eye, double fov, int width, int height) {
  DrawCamera out;
  out.pose = eye;
  out.top = std::tan(fov / 2);
  out.bottom = -out.top;
  out.right = out.top * width / height;
  out.left = -out.right;
  out.width = width;
  out.height = height;
  return out;
}

std::array<DrawCamera, 2> stereo_cameras(const Pose& head, const StereoProfile& profile, int width,
                                         int height) {
  std::array<DrawCamera, 2> out;
  const double half_width = std::tan(profile.fov_horizontal / 2);
  for (std::size_t eye = 0; eye < 2; ++eye) {
    const double side = eye == 0 ? -1 : 1;  // left, right
    const double shift = -side * profile.eye_distance / 2 / profile.convergence;
    DrawCamera& camera = out[eye];
    camera.pose = head * Pose{{side * profile.eye_distance / 2, 0, 0}, Quat::Identity()};
    camera.left = -half_width + shift;
    camera.right = half_width + shift;
    camera.top = std::tan(profile.fov_vertical / 2);
    camera.bottom = -camera.top;
    camera.width = width / 2;
    camera.height = height;
    camera.x = (eye == 0) != profile.swap_eyes ? 0 : width / 2;
  }
  return out;
}

}  // namespace prosector
