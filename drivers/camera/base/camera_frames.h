#pragma once
// Converts between the two frames of a camera. Image processing uses OpenCV's: x right, y down, z forward.
// Devices report poses in a frame with x right, y up, −z forward.

#include "common/math.h"

namespace prosector {

/// Pose of OpenCV's camera frame (x right, y down, z forward) in the device frame of the same camera (x
/// right, y up, −z forward). It is a rotation by 180° about x, which is its own inverse.
inline const Pose device_camera = {Vec3::Zero(), Quat(0, 1, 0, 0)};

}  // namespace prosector
