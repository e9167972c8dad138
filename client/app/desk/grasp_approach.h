#pragma once
// Approach of a desk user's hand to the point where it grasps.

#include <algorithm>
#include <limits>
#include <optional>

#include "client/app/desk/hand_guide.h"

namespace prosector {

/// Decides when the hand grasps after the button was pressed: when it has arrived, or when the simulated hand
/// no longer approaches the target. On a busy machine the simulated hand's updates arrive late.
class GraspApproach {
 public:
  /// Handles the press of the mouse button.
  void begin() { *this = {}; }
  void pass(double seconds) { seconds_ += seconds; }
  /// Notes the distance (m) of the simulated hand from its target in a frame of `seconds`.
  void count(double distance, double seconds) {
    const bool nearer = distance < nearest_ - min_approach;
    stalled_ = nearer ? 0 : stalled_ + seconds;
    nearest_ = std::min(nearest_, distance);
  }
  /// Returns whether the hand grasps now. `reached`: the hand has reached its target; `distance`: distance of
  /// the simulated hand from it, m; nullopt: there is no simulated hand.
  bool should_grasp(bool reached, const std::optional<double>& distance) const {
    const bool felt = distance && *distance < physical_tolerance;
    const double waited = distance ? stalled_ : seconds_;
    const bool enough = waited > stall_timeout || seconds_ > approach_timeout;
    return seconds_ >= min_press_time && ((reached && felt) || enough);
  }
  /// Returns the time since the mouse button was pressed, s.
  double seconds() const { return seconds_; }

 private:
  static constexpr double min_press_time = 0.12;  // s: shorter clicks grasp nothing
  static constexpr double stall_timeout = 0.5;    // s, of a simulated hand that stops approaching its target
  static constexpr double approach_timeout = 3;   // s, of a simulated hand that keeps approaching
  static constexpr double min_approach = 1e-3;    // m: smallest decrease of the distance that counts

  double seconds_ = 0;  // since the mouse button was pressed
  double stalled_ = 0;  // s since the simulated hand last came nearer to its target
  double nearest_ = std::numeric_limits<double>::infinity();  // m, smallest distance so far
};

}  // namespace prosector
