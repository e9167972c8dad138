#pragma once
// Two frames of one camera. Pictures are reckoned in OpenCV's: x right, y down, z ahead. All devices of ours
// have x right, y up, −z ahead.

#include "common/math.h"

namespace prosector {

/// Half a turn about x, which is its own inverse.
inline const Pose device_camera = {Vec3::Zero(), Quat(0, 1, 0, 0)};

}  // namespace prosector
