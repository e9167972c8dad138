#include "client/haptics/force_guard.h"

#include <algorithm>
#include <cmath>

namespace prosector {
namespace {

constexpr double rise_seconds = 0.3;    // s from zero to full force, once it is allowed
constexpr double fade_seconds = 0.025;  // s from full force to zero, once it is not allowed
constexpr double longest_ramp = 0.003;  // s: maximum ramp step of a cycle, as a late cycle would cause a jolt
constexpr double heat_seconds = 20;     // s, time constant of the motors' heating
constexpr double warm = 0.8;            // fraction of the continuous heat above which the force limit falls

}  // namespace

Vec3 ForceGuard::pass(const Vec3& wanted, bool allowed, bool hot, double dt) {
  const bool finite = wanted.allFinite();
  const double ramp = std::min(dt, longest_ramp);
  if (!finite) ++counts_.not_finite;
  share_ = allowed && finite ? std::min(1., share_ + ramp / rise_seconds)
                             : std::max(0., share_ - ramp / fade_seconds);
  left_ = std::max(0., left_ - ramp / fade_seconds);
  // Without a finite wanted force, the last force fades.
  Vec3 force =
      finite ? Vec3(share_ * wanted + left_ * leaving_) : Vec3(last_ * std::max(0., 1 - ramp / fade_seconds));

  const double worn = hot ? 1 : std::clamp((heat_ - warm) / (1 - warm), 0., 1.);
  const double most = bounds_.peak + worn * (bounds_.lasting - bounds_.peak);
  if (const double size = force.norm(); size > most) {
    force *= most / size;
    ++counts_.saturated;
  }
  const Vec3 change = force - last_;
  if (const double size = change.norm(), step = bounds_.slew * ramp; size > step) {
    force = last_ + change * (step / size);
    ++counts_.slowed;
  }
  const double load = force.squaredNorm() / std::pow(bounds_.lasting, 2);
  heat_ += std::min(1., dt / heat_seconds) * (load - heat_);
  last_ = force;
  return force;
}

void ForceGuard::stalled() {
  ++counts_.stalls;
  share_ = 0;
  leaving_ = last_;
  left_ = 1;
}

}  // namespace prosector
