#include "client/view/window_view.h"

#include <algorithm>
#include <cmath>

namespace prosector {
namespace {

constexpr double nearest_eye = 0.02;  // m before the screen

/// Rotates the view by the eye's angle off the centre: an eye that moves to the right sees what is farther
/// right.
DrawCamera pan(DrawCamera rest, const Vec3& eye) {
  const double right = std::atan2(eye.x(), std::max(eye.z(), nearest_eye));
  const double up = std::atan2(eye.y(), std::hypot(eye.x(), std::max(eye.z(), nearest_eye)));
  rest.pose.q = (rest.pose.q * Quat(Eigen::AngleAxisd(-right, Vec3::UnitY())) *
                 Quat(Eigen::AngleAxisd(up, Vec3::UnitX())))
                    .normalized();
  return rest;
}

}  // namespace

DrawCamera camera_through(const Pose& room_screen, const Eigen::Vector2d& size, const Vec3& eye) {
  const Vec3 at(eye.x(), eye.y(), std::max(eye.z(), nearest_eye));
  DrawCamera out;
  out.pose = {room_screen * at, room_screen.q};
  out.left = (-size.x() / 2 - at.x()) / at.z();
  out.right = (size.x() / 2 - at.x()) / at.z();
  out.bottom = (-size.y() / 2 - at.y()) / at.z();
  out.top = (size.y() / 2 - at.y()) / at.z();
  return out;
}

Vec3 resting_eye(double fov, double height) {
  return {0, 0, height / 2 / std::tan(fov / 2)};
}

DrawCamera look_through(const DrawCamera& rest, double distance, const WindowLook& look) {
  if (look.pans) return pan(rest, look.eye);
  const Pose room_screen = rest.pose * Pose{{0, 0, -distance}, Quat::Identity()};
  const Eigen::Vector2d size = distance * Eigen::Vector2d(rest.right - rest.left, rest.top - rest.bottom);
  DrawCamera out = camera_through(room_screen, size, size.y() / look.height * look.eye);
  out.near = rest.near;
  out.far = rest.far;
  out.x = rest.x;
  out.y = rest.y;
  out.width = rest.width;
  out.height = rest.height;
  return out;
}

}  // namespace prosector
