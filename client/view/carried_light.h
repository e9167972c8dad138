#pragma once
// Lights that bodies carry.

#include "common/messages.h"

namespace prosector {

/// Moves the light, given in its carrier's frame, to where the carrier is.
inline LightInfo carried_by(const Pose& carrier, LightInfo light) {
  light.position = carrier * light.position;
  light.direction = carrier.q * light.direction;
  return light;
}

}  // namespace prosector
