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

class ForceGuard {
 public:
  explicit ForceGuard(const ArmLimits& limits) : limits_(limits) {}

  /// Returns what may act: of `wanted` (N) as much as ramps and limits let through, its direction kept.
  /// `allowed`: whether force may act at all; else it fades. `hot`: the arm says that a motor is.
  Vec3 pass(const Vec3& wanted, bool allowed, bool hot, double dt);
  /// Tells that the loop stood still for longer than is safe, or knew no pose. What acts fades, and new force
  /// begins at nothing.
  void stalled();

  const GuardCounts& counts() const { return counts_; }

 private:
  ArmLimits limits_;
  double share_ = 0;  // of the force that may act: rises after a start, falls when it may not
  double heat_ = 0;   // mean square of force over what may act for long, squared
  Vec3 last_ = Vec3::Zero();
  Vec3 leaving_ = Vec3::Zero();  // N: what acted, and fades …
  double left_ = 0;              // … by this share of it
  GuardCounts counts_;
};

}  // namespace prosector
