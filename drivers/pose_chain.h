#pragma once
// How a receiver's report becomes a pose in the room: what every tracker's driver does.

#include <optional>

#include "drivers/device.h"
#include "drivers/field_map.h"

namespace prosector {

/// Applies, in order: the field map, the device's place in the room, the receiver's mount.
class PoseChain {
 public:
  /// Loads the field map that the configuration names. Throws InputError where it can't be read.
  explicit PoseChain(const DeviceConfig& config);
  /// Maps a receiver's pose in the device's frame (x right, y up, −z forward; m) into the room.
  Pose room(const Pose& device, std::size_t station) const { return from(room_device_, device, station); }
  /// Maps it where the device stands elsewhere than is configured.
  Pose from(const Pose& room_device, const Pose& device, std::size_t station) const;

 private:
  Pose room_device_;
  std::array<Pose, max_stations> mount_;
  std::optional<FieldMap> field_;
};

}  // namespace prosector
