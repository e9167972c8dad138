#pragma once
// Sample of a tracker that reports a station's position (m) and orientation in its own frame.

#include <array>
#include <optional>

#include "drivers/device/pose_chain.h"

namespace prosector {

/// Returns a pose in the device frame as the seven numbers of DeviceSample::raw_pose: position x y z (m),
/// then quaternion w x y z.
std::array<float, 7> raw_pose_of(const Pose& device);

/// Creates the sample of a tracker's receiver `station` (index from 0) at a position (m) and rotation in the
/// device frame. The sample's pose is in the room frame. Returns nothing if a number is not finite, the
/// position is beyond tracker_reach, the quaternion has no unit length, or the station does not exist. The
/// caller fills in the sample's time and other members.
std::optional<DeviceSample> station_sample(const PoseChain& chain, std::size_t station, const Vec3& place,
                                           const Quat& turn);

}  // namespace prosector
