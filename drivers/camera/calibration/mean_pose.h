#pragma once
// The mean of poses that were measured several times, each as exactly as it tells.
//
// With poses P_i of spread S_i the mean M minimises Σ ρ(d_i), d_i² = m_iᵀ S_i⁻¹ m_i, where m_i is the small
// motion from M to P_i and ρ is Huber's. What lies farther off than noise explains is left out.

#include <span>
#include <vector>

#include "drivers/camera/small_motion.h"

namespace prosector {

struct MeasuredPose {
  Pose pose;
  MotionSpread spread;
};

struct MeanPose {
  Pose pose;
  MotionSpread spread;                // of the mean; larger where poses scatter more than they told
  std::vector<std::size_t> left_out;  // by index

  /// Returns the RMS error to expect at a target, m, in the frame that the pose leads to.
  double expected_error(const Vec3& target) const { return error_at(spread, target); }
};

/// Takes the mean. Throws InputError where there is no pose, or less than half of them agree.
MeanPose mean_pose(std::span<const MeasuredPose> poses);

}  // namespace prosector
