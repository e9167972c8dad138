#pragma once
// The virtual coupling by which a hand follows its tracked pose.

#include "common/math.h"

namespace prosector::hands {

/// Parameters of a hand's virtual coupling in one tick: a spring with bounded force and moment that pulls the
/// hand's rigid body towards a displacement. Its potential is quadratic up to the bound and linear beyond it.
struct Pull {
  Vec3 translation = Vec3::Zero(), rotation = Vec3::Zero();  // m, rad: target twist
  double stiffness = 0, angular_stiffness = 0;               // N/m, N·m/rad
  double max_force = 0, max_moment = 0;                      // N, N·m
};

}  // namespace prosector::hands
