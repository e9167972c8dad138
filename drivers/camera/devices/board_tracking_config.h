#pragma once
// Settings of a tracker of printed boards beyond its camera.

#include <array>
#include <string>

#include "drivers/device/device.h"

namespace prosector {

struct BoardTrackingConfig {
  std::array<std::string, max_stations>
      boards{};  // board of each station, a known board's name or a file; empty: none
};

}  // namespace prosector
