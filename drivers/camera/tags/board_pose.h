#pragma once
// Where a board is, from its tags' corners in a straight picture.
//
// A flat board: both poses that look alike, by IPPE (Collins and Bartoli 2014). A body: SQPnP (Terzakis and
// Lourakis 2020). Each is then made best over all corners by Levenberg and Marquardt's method.

#include <span>
#include <vector>

#include "drivers/camera/small_motion.h"
#include "drivers/camera/tags/board.h"
#include "drivers/camera/tags/tag_finder.h"

namespace prosector {

struct BoardPose {
  Pose camera_board;  // OpenCV's camera frame: x right, y down, z ahead
  double rms = 0;     // pixels that corners are off
  int tags = 0;       // it rests on
};

/// A corner of a board, or any place on a picture, and where it is seen.
struct SeenCorner {
  Vec3 board;  // m
  Vec2 pixel;  // of a straight picture
};

/// Returns a board's corners with where they are seen. A code that is seen twice is left out, and counted in
/// `twice`.
std::vector<SeenCorner> corners_seen(const Board& board, std::span<const SeenTag> tags, int* twice = nullptr);

/// Returns the poses that fit, the best first: none where fewer than four corners are seen or they don't fit,
/// at most two. Tags that disagree with all others are left out.
std::vector<BoardPose> solve_board(std::span<const SeenCorner> corners, const Lens& straight);

/// Returns how a pose that rests on such corners scatters, in the camera's frame: by what they are off.
MotionSpread spread_of(const BoardPose& pose, std::span<const SeenCorner> corners, const Lens& straight);

}  // namespace prosector
