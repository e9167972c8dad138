#include "client/app/desk/desk_start.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace prosector {
namespace {

constexpr double seat_step = 20 * std::numbers::pi / 180;  // rad
constexpr int max_seats = 18;                              // a full circle
constexpr double preset_pitch = 0.35;                      // rad: looking down as at a table

double apart(double a, double b) {
  return std::abs(std::remainder(a - b, 2 * std::numbers::pi));
}

}  // namespace

double free_seat_angle(const std::vector<double>& taken) {
  for (int seat = 0; seat < max_seats; ++seat) {
    const double turn = seat_step * ((seat + 1) / 2) * (seat % 2 == 1 ? 1 : -1);
    if (std::ranges::none_of(taken, [&](double other) { return apart(other, turn) < 0.75 * seat_step; }))
      return turn;
  }
  return 0;
}

DeskStart desk_start(const CameraInfo& camera, std::span<const Vec3> anatomy, std::span<const Vec3> heads,
                     double aspect) {
  DeskStart out;
  out.fov = camera.fov;
  const ViewPlace scene = place_of(camera.eye, camera.target);
  const auto view = [&](double yaw, double pitch) {
    if (!anatomy.empty()) return framed(anatomy, yaw, pitch, camera.fov, aspect);
    return ViewPlace{scene.target, yaw, pitch, scene.distance};
  };
  const double quarter = std::numbers::pi / 2;
  out.views[0] = view(0, preset_pitch);
  out.views[1] = view(-quarter, preset_pitch);
  out.views[2] = view(quarter, preset_pitch);
  out.views[3] = view(0, max_view_pitch);
  const Vec3 middle = out.views[0]->target;
  std::vector<double> taken;
  for (const Vec3& head : heads)
    taken.push_back(std::atan2(head.x() - middle.x(), head.z() - middle.z()) - scene.yaw);
  out.home = view(scene.yaw + free_seat_angle(taken), scene.pitch);
  return out;
}

}  // namespace prosector
