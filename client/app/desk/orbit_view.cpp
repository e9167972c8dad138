#include "client/app/desk/orbit_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "client/view/camera.h"

namespace prosector {
namespace {

double wrapped(double angle) {
  return std::remainder(angle, 2 * std::numbers::pi);
}

/// Interpolates between two poses at fraction `t`: the yaw along the shorter arc, the distance geometrically.
ViewPlace between(const ViewPlace& a, const ViewPlace& b, double t) {
  return {.target = a.target + t * (b.target - a.target),
          .yaw = wrapped(a.yaw + t * wrapped(b.yaw - a.yaw)),
          .pitch = a.pitch + t * (b.pitch - a.pitch),
          .distance = a.distance * std::pow(b.distance / a.distance, t)};
}

}  // namespace

Vec3 ViewPlace::back() const {
  return {std::sin(yaw) * std::cos(pitch), std::sin(pitch), std::cos(yaw) * std::cos(pitch)};
}

Pose ViewPlace::pose() const {
  return look_at(eye(), target);
}

bool ViewPlace::is_finite() const {
  return target.allFinite() && std::isfinite(yaw) && std::isfinite(pitch) && std::isfinite(distance);
}

ViewPlace place_of(const Vec3& eye, const Vec3& target) {
  const Vec3 back = eye - target;
  const double distance = back.norm();
  if (!(distance > 0)) return bounded({.target = target});
  return bounded({.target = target,
                  .yaw = std::atan2(back.x(), back.z()),
                  .pitch = std::asin(std::clamp(back.y() / distance, -1.0, 1.0)),
                  .distance = distance});
}

ViewPlace bounded(ViewPlace place) {
  place.target = place.target.cwiseMax(-max_target_coordinate).cwiseMin(max_target_coordinate);
  place.yaw = wrapped(place.yaw);
  place.pitch = std::clamp(place.pitch, -max_view_pitch, max_view_pitch);
  place.distance = std::clamp(place.distance, min_view_distance, max_view_distance);
  return place;
}

ViewPlace framed(std::span<const Vec3> points, double yaw, double pitch, double fov, double aspect,
                 double share) {
  Eigen::AlignedBox3d box;
  for (const Vec3& x : points) box.extend(x);
  ViewPlace out{.target = box.center(), .yaw = yaw, .pitch = pitch, .distance = min_view_distance};
  const Quat camera_from_room = out.pose().q.conjugate();
  const double up = share * std::tan(fov / 2),
               across = up * aspect;  // tangents of the half angles to be filled
  for (const Vec3& point : points) {
    const Vec3 x = camera_from_room * (point - out.target);
    out.distance = std::max({out.distance, x.z() + std::abs(x.x()) / across, x.z() + std::abs(x.y()) / up});
  }
  return bounded(out);
}

ViewPlace framed(const Eigen::AlignedBox3d& box, double yaw, double pitch, double fov, double aspect,
                 double share) {
  std::array<Vec3, 8> corners;
  for (int k = 0; k < 8; ++k)
    corners[static_cast<std::size_t>(k)] = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(k));
  return framed(corners, yaw, pitch, fov, aspect, share);
}

void OrbitView::begin(const ViewPlace& home) {
  home_ = now_ = bounded(home);
  under_way_ = 1;
}

void OrbitView::set(const ViewPlace& place) {
  if (place.is_finite()) aim() = bounded(place);
}

void OrbitView::turn(double left, double up) {
  ViewPlace next = aim();
  next.yaw -= left;
  next.pitch += up;
  set(next);
}

void OrbitView::rotate_gaze(double right, double down) {
  const Vec3 eye = aim().eye();
  turn(right, down);  // an eye that moves to the left and upwards looks to the right and downwards
  ViewPlace next = aim();
  next.target = eye - next.distance * next.back();
  set(next);
}

void OrbitView::zoom(double factor) {
  ViewPlace next = aim();
  next.distance *= factor;
  set(next);
}

void OrbitView::move(const Vec3& by) {
  ViewPlace next = aim();
  next.target += by;
  set(next);
}

void OrbitView::go_to(const ViewPlace& place) {
  if (!place.is_finite()) return;
  from_ = now_;
  goal_ = bounded(place);
  under_way_ = 0;
}

void OrbitView::advance(double seconds) {
  if (under_way_ >= 1 || !(seconds > 0)) return;
  under_way_ = std::min(under_way_ + seconds / transition_seconds, 1.0);
  const double t = under_way_ * under_way_ * (3 - 2 * under_way_);
  now_ = under_way_ < 1 ? between(from_, goal_, t) : goal_;
}

}  // namespace prosector
