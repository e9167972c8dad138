#pragma once
// Transformation of a receiver's reported pose to the room frame, used by all tracker drivers.

#include <optional>

#include "drivers/device/field_map.h"
#include "drivers/device/placement.h"

namespace prosector {

/// Applies, in order: the field map, the device's pose in the room, the receiver's mount.
class PoseChain {
 public:
  /// Loads the field map of the placement. Throws InputError if it is unreadable.
  explicit PoseChain(const Placement& placement);
  /// Transforms a receiver's pose from the device frame (x right, y up, −z forward; m) to the tracked point's
  /// pose in the room frame.
  Pose room(const Pose& device, std::size_t station) const { return from(room_device_, device, station); }
  /// Transforms it with a device pose other than the configured one.
  Pose from(const Pose& room_device, const Pose& device, std::size_t station) const;

 private:
  Pose room_device_;
  std::array<Pose, max_stations> mount_;
  std::optional<FieldMap> field_;
};

}  // namespace prosector
