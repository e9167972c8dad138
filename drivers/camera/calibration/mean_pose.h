#pragma once
// Mean of several measured poses, weighted by their covariances.
//
// With poses P_i of covariance S_i the mean M minimises Σ ρ(d_i), d_i² = m_iᵀ S_i⁻¹ m_i. Here m_i is the
// small motion from M to P_i and ρ is Huber's loss. Poses farther from the mean than noise explains are left
// out.

#include <span>
#include <vector>

#include "drivers/camera/base/small_motion.h"

namespace prosector {

struct MeasuredPose {
  Pose pose;
  MotionCovariance spread;
};

struct MeanPose {
  Pose pose;
  MotionCovariance spread;            // covariance of the mean; enlarged if the poses scatter more
  std::vector<std::size_t> left_out;  // indices of the poses that were left out

  /// Returns the RMS error (m) that the uncertainty of the mean pose causes at a target position. The target
  /// (m) is in the frame in which the pose is expressed.
  double expected_error(const Vec3& target) const { return error_at(spread, target); }
};

/// Computes the mean of measured poses, weighted by their covariances. Poses farther from the others than
/// noise explains are left out. Throws InputError if there is no pose or if fewer than half of the poses
/// agree.
MeanPose mean_pose(std::span<const MeasuredPose> poses);

}  // namespace prosector
