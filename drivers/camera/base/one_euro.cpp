#include "drivers/camera/base/one_euro.h"

#include <cmath>
#include <numbers>

namespace prosector {
namespace {

/// Returns the weight of the new value in one step of a low-pass with this cut-off frequency.
double share(double cut_hz, double step_s) {
  const double x = 2 * std::numbers::pi * cut_hz * step_s;
  return x / (x + 1);
}

}  // namespace

Pose PoseFilter::update(const Pose& pose, std::int64_t time_ns) {
  const double step = state_ ? static_cast<double>(time_ns - state_->time_ns) * 1e-9 : 0;
  if (!state_ || step <= 0 || step > settings_.forgets) {
    state_ = State{pose, Vec3::Zero(), Vec3::Zero(), time_ns};
    return pose;
  }
  State& s = *state_;
  const Vec3 way = pose.p - s.pose.p;
  const Eigen::AngleAxisd turn(pose.q * s.pose.q.conjugate());
  const double angle = std::remainder(turn.angle(), 2 * std::numbers::pi);
  const double a = share(settings_.speed_cut, step);
  s.speed += a * (way / step - s.speed);
  s.turning += a * (angle * turn.axis() / step - s.turning);
  const double place = share(settings_.least + settings_.beta * s.speed.norm(), step);
  const double about = share(settings_.least + settings_.turn_beta * s.turning.norm(), step);
  s.pose.p += place * way;
  s.pose.q = s.pose.q.slerp(about, pose.q).normalized();
  s.time_ns = time_ns;
  return s.pose;
}

}  // namespace prosector
