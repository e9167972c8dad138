#pragma once
// Lights attached to bodies.

#include "common/appearance.h"
#include "common/math.h"

namespace prosector {

/// Returns the light that a body carries, transformed from the body's frame to the room. `carrier`: the
/// body's room pose.
inline LightInfo light_in_room(const Pose& carrier, LightInfo light) {
  light.position = carrier * light.position;
  light.direction = carrier.q * light.direction;
  return light;
}

}  // namespace prosector
