#include "client/haptics/haptic_loop.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "common/rotation.h"

namespace prosector {
namespace {

constexpr double usual_cycle = 1e-3;    // s
constexpr double longest_cycle = 0.02;  // s: after a longer cycle the force ramps up from zero
constexpr double cutoff = 150;          // Hz, of the velocity filter: encoders are quantised …
constexpr double slow_cutoff =
    40;  // … which the strong damping of the passivity controller must not transmit to the hand

/// Returns the hand's pose after moving with a constant velocity for dt s.
Pose moved(const Pose& hand, const HandMotion& motion, double dt) {
  return {hand.p + dt * motion.velocity, rotated_by(dt * motion.spin) * hand.q};
}

}  // namespace

HapticLoop::HapticLoop(const ArmLimits& limits, Safeguards safeguards, const Vec3& grip)
    : guard_(force_bounds(limits)),
      torque_guard_(torque_bounds(limits)),
      safeguards_(safeguards),
      grip_(grip),
      torsion_(limits.torsion) {}

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
    torque_guard_.stalled();
    passivity_.interrupt();
    forget_motion();
    if (valid) hand_ = reading.stylus;
  } else if (valid) {
    follow(reading.stylus, dt);
  }
  known_ = valid;

  // A force is held until the next cycle. On average a spring's force over the cycle is that of half a cycle
  // ahead.
  const Pose ahead = safeguards_.prediction ? moved(hand_, motion_, 0.5 * dt) : hand_;
  const FeltWrench felt = planes_.advance(ahead, motion_, ahead * grip_, dt);
  Wrench wrench = shown(felt, reading.turns);
  if (valid) {
    // Rotation against a torque that the arm can't render costs the hand no work, but is counted as energy
    // put in.
    const double unshown = std::max(0., -(felt.wrench.torque - wrench.torque).dot(motion_.spin));
    passivity_.observe(stylus(), felt.stored, felt.power + unshown, dt);
    const HandMotion damped = {slow_motion_.velocity, reading.turns ? slow_motion_.spin : Vec3(Vec3::Zero())};
    if (safeguards_.passivity) wrench = passivity_.damp(wrench, damped, dt);
  } else {
    passivity_.interrupt();
  }
  allowed = allowed && valid && !planes_.stale(time);
  acts_.force = guard_.pass(wrench.force, allowed, reading.hot, dt);
  acts_.torque =
      reading.turns ? torque_guard_.pass(wrench.torque, allowed, reading.hot, dt) : Vec3(Vec3::Zero());
  passivity_.applied(acts_);
  // If only a fraction of the force passes the guard, the stiffness is scaled by the same fraction.
  const double asked = wrench.force.norm();
  stiffness_ = std::isfinite(asked) && asked > 0
                   ? Mat3(std::min(1., acts_.force.norm() / asked) * felt.stiffness)
                   : Mat3(Mat3::Zero());
  return acts_.force;
}

/// Returns the force and torque that the arm can render. Torque is scaled down if the torsional stiffness
/// exceeds the arm's stable limit.
Wrench HapticLoop::shown(const FeltWrench& felt, bool turns) const {
  Wrench out{felt.wrench.force, Vec3::Zero()};
  if (turns) out.torque = (felt.torsion > torsion_ ? torsion_ / felt.torsion : 1) * felt.wrench.torque;
  return out;
}

/// Updates the hand's pose and filtered velocities.
void HapticLoop::follow(const Pose& hand, double dt) {
  const auto share = [&](double at) { return 1 - std::exp(-2 * std::numbers::pi * at * dt); };
  const Pose before = std::exchange(hand_, hand);
  const HandMotion now = {(hand.p - before.p) / dt, turn(before.q, hand.q) / dt};
  motion_.velocity += share(cutoff) * (now.velocity - motion_.velocity);
  motion_.spin += share(cutoff) * (now.spin - motion_.spin);
  slow_motion_.velocity += share(slow_cutoff) * (now.at(hand.q * grip_) - slow_motion_.velocity);
  slow_motion_.spin += share(slow_cutoff) * (now.spin - slow_motion_.spin);
}

void HapticLoop::forget_motion() {
  motion_ = slow_motion_ = {};
}

}  // namespace prosector
