#pragma once
// Rolling resistance (Johnson 1985, "Contact Mechanics", 9.1). The contact force on a rolling body acts
// slightly ahead of the contact point, because material returns less force in unloading than in loading.

#include "common/math.h"

namespace prosector::rigid {

/// One of the two bodies at a rolling contact: its rolling resistance, centre of mass and angular velocity.
struct RollingSide {
  double resistance = 0;       // coefficient: ratio of resisting force to load for free rolling
  Vec3 middle = Vec3::Zero();  // m: centre of mass
  Vec3 spin = Vec3::Zero();    // rad/s, world frame
};

/// Returns the lever (m) of the moment that resists rolling at a contact: multiplied by the normal force, it
/// gives the moment. It is the sum, over both bodies, of rolling resistance times height of the centre of
/// mass above the contact's tangent plane. `point`: contact point; `normal`: unit vector from b to a.
double rolling_lever(const RollingSide& a, const RollingSide& b, const Vec3& point, const Vec3& normal);

/// Returns by how much (m, world frame) rolling resistance displaces the contact force from the contact
/// point. The offset has the length of rolling_lever() and the direction of rolling. It falls to zero with
/// the rolling speed, so that it moves no body at rest.
Vec3 rolling_lead(const RollingSide& a, const RollingSide& b, const Vec3& point, const Vec3& normal);

}  // namespace prosector::rigid
