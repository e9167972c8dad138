#pragma once
// Sample of a tracker that reports a station's position (m) and orientation in its own frame.

#include <array>
#include <optional>

#include "drivers/device/pose_chain.h"

namespace prosector {

/// Returns a pose in the device frame in the layout of DeviceSample::raw_pose: position, then quaternion w x
/// y z.
std::array<float, 7> raw_pose_of(const Pose& device);

/// Creates the sample of a station, with its pose in the room frame. Returns nothing if a number is not
/// finite, the position is beyond tracker_reach or the quaternion is not a unit quaternion. The caller fills
/// in the other fields.
std::optional<DeviceSample> station_sample(const PoseChain& chain, std::size_t station, const Vec3& place,
                                           const Quat& turn);

}  // namespace prosector
