#pragma once
// Where a fixed camera stands in a tracker's frame, from a board that is fixed to the tracker's receiver.
//
// Pairs of poses, of the receiver T_i and of the board C_i in the camera's frame, obey T_i Y = X C_i. X, the
// camera's pose in the tracker's frame, and Y, the board's in the receiver's, come from Shah 2013. Park and
// Martin 1994 must say the same. Both weigh turns and places as they come, so X and Y are then made best:
//   Σ |p(T_i) − p(X C_i Y⁻¹)|²/σ_p² + |turn between both|²/σ_t²,
// with σ_p and σ_t as the pairs themselves scatter. Pairs that are farther off than noise explains are left
// out.

#include <span>
#include <vector>

#include "drivers/camera/small_motion.h"

namespace prosector {

inline constexpr std::size_t least_tracked_pairs = 6;
inline constexpr std::size_t usual_tracked_pairs = 20;
inline constexpr double least_second_turn =
    0.1;  // rad RMS, about the axis that turns were second widest about

struct TrackedPair {
  Pose tracker_receiver;
  Pose camera_board;  // OpenCV's camera frame
};

struct TrackerFit {
  Pose tracker_camera;  // OpenCV's camera frame
  Pose receiver_board;
  MotionSpread spread;                 // of the camera's pose, in the tracker's frame
  double place_off = 0, turn_off = 0;  // m, rad: RMS that receivers are off, all three axes together
  double ways_apart = 0;               // m that both ways differ by amid the boards
  Vec3 centre = Vec3::Zero();          // of the boards, tracker's frame
  std::vector<std::size_t> left_out;   // by index

  /// Returns the RMS error to expect of what the camera sees at a target in the tracker's frame, m.
  double expected_error(const Vec3& target) const { return error_at(spread, target); }
};

/// Fits. Throws InputError that says what to do where pairs are too few, turned about one axis only, or don't
/// belong together.
TrackerFit fit_tracker(std::span<const TrackedPair> pairs);

}  // namespace prosector
