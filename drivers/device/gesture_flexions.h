#pragma once
// Maps finger flexions detected by a camera to those that gesture thresholds expect.
//
// Closed fingers occlude each other and their own tips. The networks then detect a fist as half open, to a
// degree that depends on the view. Thumbs close less than fingers.

#include <array>

#include "common/hand_pose.h"

namespace prosector {

/// Maps finger flexions (0 open … 1 closed, thumb first) that a camera detected to the scale that the gesture
/// thresholds of gloves expect; 0 and 1 stay unchanged. The mapping is monotonic per finger, except that four
/// equally half-bent fingers count as a fist.
std::array<double, fingers> gesture_flexions(const std::array<double, fingers>& seen);

}  // namespace prosector
