#pragma once
// Catches places one after the other: each counts once it is held still, and after the last one was left.

#include <optional>

#include "drivers/fitting/still_window.h"

namespace prosector {

class PlaceCatcher {
 public:
  /// Takes `leave`, m by which a place must be left before the next counts; so must where it all began.
  explicit PlaceCatcher(double leave, const StillLimits& limits = {}) : window_(limits), leave_(leave) {}

  /// Takes a reading. Returns the mean pose once a new place is held still; then waits to be left.
  std::optional<Pose> take(std::int64_t time_ns, const Pose& pose);
  /// Returns how long the present place is held, 0 to 1.
  double held() const { return left_ ? window_.filled() : 0; }
  /// Returns how far off the place that was caught last is to be expected.
  const PoseErrors& error() const { return window_.mean_error(); }

 private:
  StillWindow window_;
  double leave_;
  std::optional<Vec3> last_;
  bool left_ = false;
};

}  // namespace prosector
