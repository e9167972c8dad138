#pragma once
// Rolling resistance (Johnson 1985, "Contact Mechanics", 9.1). The contact force on a rolling body acts
// slightly ahead of the contact point, because material returns less force in unloading than in loading.

#include "common/math.h"

namespace prosector {

/// One body at a contact with another.
struct RollingSide {
  double resistance = 0;       // coefficient: ratio of resisting force to load for free rolling
  Vec3 middle = Vec3::Zero();  // m: centre of mass
  Vec3 spin = Vec3::Zero();    // rad/s, world frame
};

/// Returns the lever (m) of the moment that resists rolling: the sum of each body's resistance times the
/// height of its centre over the point. `normal` is a unit vector from b to a.
double rolling_lever(const RollingSide& a, const RollingSide& b, const Vec3& point, const Vec3& normal);

/// Returns the offset (m, world frame) of the contact force from the contact point: the lever, in the
/// direction of rolling. It falls to zero with the rolling speed, so that it moves no body at rest.
Vec3 rolling_lead(const RollingSide& a, const RollingSide& b, const Vec3& point, const Vec3& normal);

}  // namespace prosector
