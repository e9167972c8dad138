#pragma once
// Pose of a fixed camera in a tracker's frame, from a board that is fixed to the tracker's receiver.
//
// The pairs of poses, T_i of the receiver and C_i of the board in the camera's frame, obey T_i Y = X C_i. X
// is the camera's pose in the tracker's frame, Y the board's pose in the receiver's frame. Shah 2013 gives
// both. X must agree with the result of Park and Martin 1994. Both methods use fixed weights for rotation and
// translation, so X and Y are then refined to minimise
//   Σ |p(T_i) − p(X C_i Y⁻¹)|²/σ_p² + |rotation between T_i and X C_i Y⁻¹|²/σ_t²,
// with σ_p and σ_t estimated from the scatter of the pairs. Pairs farther off than noise explains are left
// out.

#include <span>
#include <vector>

#include "drivers/camera/base/small_motion.h"

namespace prosector {

inline constexpr std::size_t min_tracked_pairs = 6;
inline constexpr std::size_t recommended_tracked_pairs = 20;
inline constexpr double min_second_axis_rotation = 0.1;  // rad RMS, least rotation about the second axis: the
                                                         // one with the second largest spread of rotations

struct TrackedPair {
  Pose tracker_receiver;
  Pose camera_board;  // in OpenCV's camera frame
};

struct TrackerFit {
  Pose tracker_camera;  // pose of OpenCV's camera frame in the tracker's frame
  Pose receiver_board;
  MotionCovariance spread;  // covariance of the camera's pose, in the tracker's frame
  double position_rms = 0,
         rotation_rms = 0;            // m, rad: RMS errors of the receiver's poses, all three axes together
  double method_difference = 0;       // m, between Shah's and Park and Martin's results at the boards
  Vec3 centre = Vec3::Zero();         // m, mean position of the boards in the tracker's frame
  std::vector<std::size_t> left_out;  // indices of the pairs that were left out

  /// Returns the expected RMS error (m) that the fitted camera pose causes in camera measurements at a target
  /// position. The target is in the tracker's frame, m.
  double expected_error(const Vec3& target) const { return error_at(spread, target); }
};

/// Fits the camera's pose in the tracker's frame and the board's pose in the receiver's frame to pairs of
/// measured poses. Throws InputError with advice if the pairs are too few, rotated about one axis only, or
/// inconsistent.
TrackerFit fit_tracker(std::span<const TrackedPair> pairs);

}  // namespace prosector
