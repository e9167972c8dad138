#pragma once
// Last stage before a force reaches a hand: limits force, rate of change and heat independently of errors in
// earlier stages.

#include <cstdint>

#include "drivers/device/arm.h"

namespace prosector {

/// Numbers of cycles in which the guard intervened; for reports.
struct GuardCounts {
  std::uint64_t not_finite = 0;  // non-finite forces
  std::uint64_t saturated = 0;   // forces beyond the arm's peak force or, when hot, its continuous force
  std::uint64_t slowed = 0;      // forces that changed faster than allowed
  std::uint64_t stalls = 0;      // cycles that came too late, or whose pose was valid again after a gap
};

/// Limits of an arm's force (N, N/s) or torque (N·m, N·m/s).
struct GuardBounds {
  double peak = 0, lasting = 0, slew = 0;
};
inline GuardBounds force_bounds(const ArmLimits& limits) {
  return {limits.peak_force, limits.continuous_force, limits.max_slew};
}
/// Returns the limits of torque. Its slew rate is such that it reaches its peak in the same time as force
/// does.
inline GuardBounds torque_bounds(const ArmLimits& limits) {
  return {limits.peak_torque, limits.peak_torque, limits.max_slew * limits.peak_torque / limits.peak_force};
}

class ForceGuard {
 public:
  explicit ForceGuard(const GuardBounds& bounds) : bounds_(bounds) {}

  /// Returns the admissible force: `wanted` limited by ramps and bounds, in its direction. `allowed`: whether
  /// force may act at all; otherwise it fades. `hot`: the arm reports a hot motor. `dt`: s since the last
  /// call; the force changes by no more than in 3 ms, however late the call is.
  Vec3 pass(const Vec3& wanted, bool allowed, bool hot, double dt);
  /// Restarts after the loop stopped for longer than is safe, or had no valid pose. The present force fades,
  /// and new force ramps up from zero.
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
