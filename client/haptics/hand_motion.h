#pragma once
// How a hand moves and what acts on it, as one: along and about.

#include "common/math.h"

namespace prosector {

/// How fast a hand moves, room frame.
struct HandMotion {
  Vec3 velocity = Vec3::Zero();  // m/s, of a point of it
  Vec3 spin = Vec3::Zero();      // rad/s

  /// Returns the velocity of what is that far away from that point, m.
  Vec3 at(const Vec3& away) const { return velocity + spin.cross(away); }
};

/// What acts on a hand, room frame.
struct Wrench {
  Vec3 force = Vec3::Zero();   // N
  Vec3 torque = Vec3::Zero();  // N·m, about where the force acts
};

}  // namespace prosector
