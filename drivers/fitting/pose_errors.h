#pragma once
// Errors of poses.

namespace prosector {

/// RMS errors of poses, all three axes together.
struct PoseErrors {
  double position = 0, turn = 0;  // m, rad
};

}  // namespace prosector
