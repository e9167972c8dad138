#pragma once
// Records positions one after another: each counts once it is held still after the previous one was left.

#include <optional>

#include "drivers/fitting/stillness_detector.h"

namespace prosector {

class PositionRecorder {
 public:
  /// Starts recording positions that a receiver holds. The receiver must move by `leave` metres away from the
  /// start and from each recorded position before the next one counts.
  explicit PositionRecorder(double leave, const StillnessLimits& limits = {})
      : window_(limits), leave_(leave) {}

  /// Processes a pose of the receiver. Returns the mean pose when the receiver is held still at a new
  /// position, then nothing until it has left this position.
  std::optional<Pose> take(std::int64_t time_ns, const Pose& pose);
  /// Returns the fraction (0 to 1) of the required time for which the receiver has been held at the present
  /// position. Returns 0 until it has left the last recorded position.
  double held() const { return left_ ? window_.filled() : 0; }
  /// Returns the expected error of the last recorded position, m, and of its orientation, rad.
  const PoseErrors& error() const { return window_.mean_error(); }

 private:
  StillnessDetector window_;
  double leave_;
  std::optional<Vec3> last_;
  bool left_ = false;
};

}  // namespace prosector
