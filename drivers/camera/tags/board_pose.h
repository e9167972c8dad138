#pragma once
// Pose of a board from its tags' corners in an undistorted image.
//
// A flat board gives the two ambiguous poses by IPPE (Collins and Bartoli 2014). A three-dimensional board
// uses SQPnP (Terzakis and Lourakis 2020). Each pose is then refined over all corners by Levenberg and
// Marquardt's method.

#include <span>
#include <vector>

#include "drivers/camera/base/small_motion.h"
#include "drivers/camera/tags/board.h"
#include "drivers/camera/tags/tag_detector.h"

namespace prosector {

struct BoardPose {
  Pose camera_board;  // OpenCV's camera frame: x right, y down, z forward
  double rms = 0;     // pixels, reprojection error of the corners
  int tags = 0;       // number of tags used
};

/// A point of a board (a tag's corner, or a point of a printed image) and the pixel at which it was detected.
struct DetectedCorner {
  Vec3 board;  // m
  Vec2 pixel;  // in an undistorted image
};

/// Returns the corners of those detected tags that belong to the board. Tags whose code was detected more
/// than once are left out; `twice`, if not null, is increased by the number of these tags.
std::vector<DetectedCorner> corners_seen(const Board& board, std::span<const DetectedTag> tags,
                                         int* twice = nullptr);

/// Computes poses of a board in the camera's frame from its detected points. `straight` is the lens of the
/// undistorted image. Returns at most two poses that fit, because a flat board is ambiguous, the best first.
/// Returns none if fewer than four corners are given or no pose fits. Tags that disagree with all others are
/// left out.
std::vector<BoardPose> solve_board(std::span<const DetectedCorner> corners, const Lens& straight);

/// Returns the covariance of a board's pose computed from these corners, in the camera's frame, scaled by the
/// residuals of the corners. `straight` is the lens of the undistorted image.
MotionCovariance spread_of(const BoardPose& pose, std::span<const DetectedCorner> corners,
                           const Lens& straight);

}  // namespace prosector
