#pragma once
// Motion and load of a hand, linear and angular.

#include "common/math.h"

namespace prosector {

/// Velocity and angular velocity of a hand, room frame.
struct HandMotion {
  Vec3 velocity = Vec3::Zero();  // m/s, of a reference point of the hand
  Vec3 spin = Vec3::Zero();      // rad/s

  /// Returns the velocity, m/s, of the hand's point at offset `away` (m, room frame) from the reference
  /// point.
  Vec3 at(const Vec3& away) const { return velocity + spin.cross(away); }
};

/// Force and torque on a hand, room frame.
struct Wrench {
  Vec3 force = Vec3::Zero();   // N
  Vec3 torque = Vec3::Zero();  // N·m, about the point at which the force acts
};

}  // namespace prosector
