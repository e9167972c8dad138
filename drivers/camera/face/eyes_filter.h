#pragma once
// Smooths the pose of a head. The distance along the camera's axis is ten times less exact than the position
// across it.

#include "drivers/camera/base/one_euro.h"

namespace prosector {

class EyesFilter {
 public:
  /// Processes the pose of the head in the camera's frame (m) measured at `time_ns` and returns the smoothed
  /// pose. Times must increase; a decrease resets the filter.
  Pose update(const Pose& camera_head, std::int64_t time_ns);

 private:
  PoseFilter across_{{.least = 1.5, .beta = 30, .turn_beta = 5}};  // directions at distance 1, and rotations
  PoseFilter along_{{.least = 0.5, .beta = 6}};                    // distance along the camera's axis
};

}  // namespace prosector
