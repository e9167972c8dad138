#pragma once
// Placement of a tracker: its pose in the room, its active stations, and what is attached to them.

#include <array>
#include <cstdint>
#include <string>

#include "common/math.h"
#include "drivers/device/device.h"

namespace prosector {

struct Placement {
  Pose room_device;  // pose of the device frame (tracker: x right, y up, −z forward) in the room frame
  std::uint32_t stations = 1;            // bit mask of active stations
  std::array<Pose, max_stations> mount;  // pose of the tracked point (wrist, eyes) in its receiver's frame
  std::string field_map;                 // file with the magnetic field distortion map; empty: none
};

}  // namespace prosector
