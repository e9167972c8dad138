#pragma once
// Lights attached to bodies.

#include "common/appearance.h"
#include "common/math.h"

namespace prosector {

/// Transforms a light from its carrier's frame to the frame of the carrier's pose.
inline LightInfo light_in_room(const Pose& carrier, LightInfo light) {
  light.position = carrier * light.position;
  light.direction = carrier.q * light.direction;
  return light;
}

}  // namespace prosector
