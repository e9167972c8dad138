#pragma once
// Errors of poses.

namespace prosector {

/// RMS errors of poses: error of the position, m, and of the rotation angle, rad, each for all three axes
/// together.
struct PoseErrors {
  double position = 0, turn = 0;  // m, rad
};

}  // namespace prosector
