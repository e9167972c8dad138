#pragma once
// Settings of a FASTRAK tracker beyond its placement.

#include <array>
#include <optional>

#include "common/math.h"

namespace prosector {

struct FastrakConfig {
  bool binary = true;                              // binary records; false: ASCII
  Vec3 hemisphere = {1, 0, 0};                     // zenith of the operational hemisphere, transmitter frame
  bool boresight = false;                          // boresight every station when it starts
  std::optional<std::array<double, 9>> alignment;  // O, X, Y points of the alignment frame, cm
};

}  // namespace prosector
