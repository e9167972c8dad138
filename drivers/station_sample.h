#pragma once
// The sample of a tracker that tells a station's place (m) and turn in a frame of its own.

#include <array>
#include <optional>

#include "drivers/pose_chain.h"

namespace prosector {

/// Returns a pose in the device's frame as samples have it raw: place, then turn.
std::array<float, 7> raw_pose_of(const Pose& device);

/// Returns the sample of a station, in the room. Returns nothing for what is no number, farther than any
/// tracker sees, or no unit quaternion. Who calls fills in the rest.
std::optional<DeviceSample> station_sample(const PoseChain& chain, std::size_t station, const Vec3& place,
                                           const Quat& turn);

}  // namespace prosector
