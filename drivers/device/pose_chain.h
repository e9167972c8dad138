#pragma once
// Transformation of a receiver's reported pose to the room frame, used by all tracker drivers.

#include <optional>

#include "drivers/device/field_map.h"
#include "drivers/device/placement.h"

namespace prosector {

/// Transformation of a tracker's reported poses to poses of the tracked points in the room. It applies the
/// map that corrects magnetic distortion, the device's pose in the room, and the receiver's mount, in this
/// order.
class PoseChain {
 public:
  /// Takes the poses of the device and of its receivers' mounts from `placement`, and loads the map that
  /// corrects magnetic distortion, if one is named. Throws InputError if the map is unreadable.
  explicit PoseChain(const Placement& placement);
  /// Transforms the pose of receiver `station` (index from 0) from the device frame (x right, y up, −z
  /// forward; m) to the room frame. Returns the pose of the tracked point (wrist or eyes).
  Pose room(const Pose& device, std::size_t station) const { return from(room_device_, device, station); }
  /// Transforms the pose of receiver `station` like room(), but with `room_device` as the device's pose in
  /// the room instead of the configured one.
  Pose from(const Pose& room_device, const Pose& device, std::size_t station) const;

 private:
  Pose room_device_;
  std::array<Pose, max_stations> mount_;
  std::optional<FieldMap> field_;
};

}  // namespace prosector
