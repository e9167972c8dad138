#pragma once
// Last stage before a force reaches a hand: limits force, rate of change and heat independently of errors in
// earlier stages.

#include <cstdint>

#include "drivers/device/arm.h"

namespace prosector {

/// Numbers of servo cycles in which the force guard, the last limiter of an arm's force, intervened, by
/// reason.
struct GuardCounts {
  std::uint64_t not_finite = 0;  // non-finite forces
  std::uint64_t saturated = 0;   // forces beyond the arm's peak force or, when hot, its continuous force
  std::uint64_t slowed = 0;      // forces that changed faster than allowed
  std::uint64_t stalls = 0;      // cycles that came too late, or whose pose was valid again after a gap
};

/// Limits of a haptic arm's force (N) or torque (N·m): peak value, continuous value, and rate of change (N/s
/// or N·m/s).
struct GuardBounds {
  double peak = 0, lasting = 0, slew = 0;
};
inline GuardBounds force_bounds(const ArmLimits& limits) {
  return {limits.peak_force, limits.continuous_force, limits.max_slew};
}
/// Returns the limits of the arm's torque. The maximum rate of change is chosen so that torque reaches its
/// peak in the same time as force does.
inline GuardBounds torque_bounds(const ArmLimits& limits) {
  return {limits.peak_torque, limits.peak_torque, limits.max_slew * limits.peak_torque / limits.peak_force};
}

class ForceGuard {
 public:
  explicit ForceGuard(const GuardBounds& bounds) : bounds_(bounds) {}

  /// Returns the admissible force in N (or torque, N·m): `wanted`, faded in or out and limited in size, rate
  /// of change and heat. While `allowed` is false, force fades to zero. `hot`: the arm reports a hot motor.
  /// `dt`: time since the last call, s; after a longer interval the force changes by no more than in 3 ms.
  Vec3 pass(const Vec3& wanted, bool allowed, bool hot, double dt);
  /// Restarts the ramps after the servo loop stopped for longer than is safe, or had no valid pose. The
  /// present force fades to zero, and the newly wanted force ramps up from zero.
  void stalled();

  const GuardCounts& counts() const { return counts_; }

 private:
  GuardBounds bounds_;
  double share_ = 0;  // fraction of the wanted force: rises after a start, falls while force is not allowed
  double heat_ = 0;   // mean of (force / continuous force)², low-pass filtered
  Vec3 last_ = Vec3::Zero();
  Vec3 leaving_ = Vec3::Zero();  // N: force at the last stall, which fades …
  double left_ = 0;              // … with this factor
  GuardCounts counts_;
};

}  // namespace prosector
