#pragma once
// Records positions one after another: each counts once it is held still after the previous one was left.

#include <optional>

#include "drivers/fitting/stillness_detector.h"

namespace prosector {

class PositionRecorder {
 public:
  /// Starts the recorder. `leave`: distance in m by which the start and each recorded position must be left
  /// before the next one counts.
  explicit PositionRecorder(double leave, const StillnessLimits& limits = {})
      : window_(limits), leave_(leave) {}

  /// Processes a reading. Returns the mean pose once a new position is held still, then waits until it is
  /// left.
  std::optional<Pose> take(std::int64_t time_ns, const Pose& pose);
  /// Returns the share of the required time for which the present position has been held, 0 to 1.
  double held() const { return left_ ? window_.filled() : 0; }
  /// Returns the expected error of the last recorded position.
  const PoseErrors& error() const { return window_.mean_error(); }

 private:
  StillnessDetector window_;
  double leave_;
  std::optional<Vec3> last_;
  bool left_ = false;
};

}  // namespace prosector
