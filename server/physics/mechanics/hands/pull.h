#pragma once
// The virtual coupling by which a hand follows its tracked pose.

#include "common/math.h"

namespace prosector {

/// The virtual coupling of a hand: pulls a rigid body towards a displacement, with bounded force and moment.
/// The potential is quadratic up to the bound, and linear beyond it.
struct Pull {
  Vec3 translation = Vec3::Zero(), rotation = Vec3::Zero();  // m, rad: target twist
  double stiffness = 0, angular_stiffness = 0;               // N/m, N·m/rad
  double max_force = 0, max_moment = 0;                      // N, N·m
};

}  // namespace prosector
