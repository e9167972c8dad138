#pragma once
// Withdrawal of a desk user's hand whose simulated hand is stuck, for instance behind an organ after the view
// was rotated.

#include <limits>
#include <optional>

#include "common/math.h"

namespace prosector {

/// Detects that the simulated hand is stuck away from its target. Then the hand is withdrawn, that is,
/// reported as untracked, until the server has removed the simulated hand.
class HandWithdrawal {
 public:
  /// Advances by a frame of `seconds`. `may`: the hand hovers above a surface and simulated time advances;
  /// otherwise a withdrawal ends. `physical`: pose of the simulated wrist, `target`: position of the wrist,
  /// m, world frame.
  void advance(bool may, const std::optional<Pose>& physical, const Vec3& target, double seconds) {
    if (withdrawn_) {
      seconds_withdrawn_ += seconds;
      withdrawn_ = may && physical && seconds_withdrawn_ < withdrawal_timeout;
      return;
    }
    if (!may || !physical || (physical->p - target).norm() < blocked_from) {
      blocked_ = {};
      return;
    }
    blocked_.count(physical->p, seconds);
    if (blocked_.seconds >= blocked_timeout) withdraw();
  }
  bool is_withdrawn() const { return withdrawn_; }

 private:
  static constexpr double blocked_from = 0.08;      // m, between the simulated hand and its target
  static constexpr double blocked_radius = 0.02;    // m: a hand that moves less counts as blocked
  static constexpr double blocked_timeout = 1;      // s
  static constexpr double withdrawal_timeout = 10;  // s, in case a slow server does not remove the hand

  /// Timer of a blocked hand: time since the simulated hand last moved.
  struct Blocked {
    double seconds = 0;
    Vec3 at = Vec3::Constant(std::numeric_limits<double>::infinity());  // m, world frame
    void count(const Vec3& physical, double passed) {
      const bool moved = !((physical - at).norm() < blocked_radius);
      seconds = moved ? 0 : seconds + passed;
      if (moved) at = physical;
    }
  };
  Blocked blocked_;  // while it hovers away from its target
  bool withdrawn_ = false;
  double seconds_withdrawn_ = 0;

  void withdraw() {
    blocked_ = {};
    withdrawn_ = true;
    seconds_withdrawn_ = 0;
  }
};

}  // namespace prosector
