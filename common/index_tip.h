#pragma once
// Position of the index fingertip.

#include "common/hand.h"
#include "common/hand_pose.h"
#include "common/math.h"

namespace prosector {

inline constexpr std::size_t index_knuckle = 2, index_end = 4;  // the index finger's first and last segment

/// Returns the position of the tip of the index finger (m, room frame) of a hand, left or right, with the
/// given pose and flexions.
inline Vec3 index_tip(std::size_t hand, const HandPose& pose) {
  const Pose segment = pose.pose * hand_pose(hand, pose.flexion)[index_end];
  return segment * Vec3(0, 0, -hand_segments(hand)[index_end].length);
}

}  // namespace prosector
