#pragma once
// Smooths where a head is: across the camera's view it is known well, along it ten times worse.

#include "drivers/camera/one_euro.h"

namespace prosector {

class EyesFilter {
 public:
  /// Returns the head's pose in the camera's frame smoothed. Times must not fall; one that does begins anew.
  Pose update(const Pose& camera_head, std::int64_t time_ns);

 private:
  PoseFilter across_{{.least = 1.5, .beta = 30, .turn_beta = 5}};  // of directions at distance 1, and turns
  PoseFilter along_{{.least = 0.5, .beta = 6}};                    // of the distance
};

}  // namespace prosector
