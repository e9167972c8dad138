#include "client/haptics/haptic_loop.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace prosector {
namespace {

constexpr double usual_cycle = 1e-3;    // s
constexpr double longest_cycle = 0.02;  // s: after a longer one force begins at nothing again
constexpr double cutoff = 150;          // Hz, of the velocity's filter: encoders have steps …
constexpr double slow_cutoff = 40;      // … which the passivity's strong damping must not make felt

}  // namespace

void HapticLoop::take(std::span<const ContactPlane> planes, double time) {
  planes_.take(planes, time);
}

Vec3 HapticLoop::cycle(const ArmReading& reading, double time, bool allowed) {
  const double since = time - time_;
  time_ = time;
  const bool valid = reading.valid && is_finite(reading.stylus);
  const bool on_time = since > 0 && since <= longest_cycle;
  const double dt = on_time ? since : usual_cycle;
  if (!on_time || (valid && !known_)) {
    guard_.stalled();
    passivity_.interrupt();
    velocity_.setZero();
    slow_velocity_.setZero();
    if (valid) hand_ = reading.stylus;
  } else if (valid) {
    follow(reading.stylus, dt);
  }
  known_ = valid;

  // A force is held until the next cycle. What a spring would do meanwhile is what it does half a cycle on.
  Pose ahead = hand_;
  if (safeguards_.prediction) ahead.p += 0.5 * dt * velocity_;
  const PlaneForce felt = planes_.advance(ahead, velocity_, dt);
  Vec3 force = felt.force;
  if (valid) {
    passivity_.observe(hand_.p, felt.stored, felt.power, dt);
    if (safeguards_.passivity) force = passivity_.damp(force, slow_velocity_, dt);
  } else {
    passivity_.interrupt();
  }
  force_ = guard_.pass(force, allowed && valid && !planes_.stale(time), reading.hot, dt);
  passivity_.applied(force_);
  // What lets through a part of the force lets through that part of its slope.
  const double asked = force.norm();
  stiffness_ = std::isfinite(asked) && asked > 0 ? Mat3(std::min(1., force_.norm() / asked) * felt.stiffness)
                                                 : Mat3(Mat3::Zero());
  return force_;
}

/// Takes where the hand is now, and how fast.
void HapticLoop::follow(const Pose& stylus, double dt) {
  const auto share = [&](double at) { return 1 - std::exp(-2 * std::numbers::pi * at * dt); };
  const Vec3 velocity = (stylus.p - hand_.p) / dt;
  velocity_ += share(cutoff) * (velocity - velocity_);
  slow_velocity_ += share(slow_cutoff) * (velocity - slow_velocity_);
  hand_ = stylus;
}

}  // namespace prosector
