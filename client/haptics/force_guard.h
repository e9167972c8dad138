#pragma once
// What stands between any computed force and a hand: bounds, ramps and heat, whatever the rest got wrong.

#include <cstdint>

#include "drivers/arm.h"

namespace prosector {

/// What the guard had to do, counted in cycles; for reports.
struct GuardCounts {
  std::uint64_t not_finite = 0;  // forces that were no numbers
  std::uint64_t saturated = 0;   // beyond the arm's peak force, or beyond what it bears for long
  std::uint64_t slowed = 0;      // that rose or fell faster than allowed
  std::uint64_t stalls = 0;      // cycles that came too late
};

/// What an arm bears of force (N, N/s) or of torque (N·m, N·m/s).
struct GuardBounds {
  double peak = 0, lasting = 0, slew = 0;
};
inline GuardBounds force_bounds(const ArmLimits& limits) {
  return {limits.peak_force, limits.continuous_force, limits.max_slew};
}
/// Returns those of torque, which comes as fast as force does: from none to its peak in the same time.
inline GuardBounds torque_bounds(const ArmLimits& limits) {
  return {limits.peak_torque, limits.peak_torque, limits.max_slew * limits.peak_torque / limits.peak_force};
}

class ForceGuard {
 public:
  explicit ForceGuard(const GuardBounds& bounds) : bounds_(bounds) {}

  /// Returns what may act: of what is `wanted` as much as ramps and bounds let through, its direction kept.
  /// `allowed`: whether force may act at all; else it fades. `hot`: the arm says that a motor is. `dt`: s
  /// since the last call. Force changes by no more than in 3 ms, however late the call is.
  Vec3 pass(const Vec3& wanted, bool allowed, bool hot, double dt);
  /// Tells that the loop stood still for longer than is safe, or knew no pose. What acts fades, and new force
  /// begins at nothing.
  void stalled();

  const GuardCounts& counts() const { return counts_; }

 private:
  GuardBounds bounds_;
  double share_ = 0;  // of the force that may act: rises after a start, falls when it may not
  double heat_ = 0;   // mean square of force over what may act for long, squared
  Vec3 last_ = Vec3::Zero();
  Vec3 leaving_ = Vec3::Zero();  // N: what acted, and fades …
  double left_ = 0;              // … by this share of it
  GuardCounts counts_;
};

}  // namespace prosector
