#pragma once
// Rolling resistance (Johnson 1985, "Contact Mechanics", 9.1). What bears a body that rolls bears it a little
// ahead of where it touches: material gives back less in rising than it took in being pressed.

#include "common/math.h"

namespace prosector {

/// One body where it touches another.
struct RollingSide {
  double resistance = 0;       // coefficient: the resisting force over the load, where the body rolls freely
  Vec3 middle = Vec3::Zero();  // m: its centre of mass
  Vec3 spin = Vec3::Zero();    // rad/s, world frame
};

/// Returns the lever (m) at which a pair of forces resists rolling: the sum of each body's resistance times
/// the height of its middle over the point. `normal` is a unit vector from b to a.
double rolling_lever(const RollingSide& a, const RollingSide& b, const Vec3& point, const Vec3& normal);

/// Returns how far (m, world frame) the force between two bodies leads the point where they touch: the lever
/// ahead. It falls to zero with the speed of rolling, so that nothing is moved by it.
Vec3 rolling_lead(const RollingSide& a, const RollingSide& b, const Vec3& point, const Vec3& normal);

}  // namespace prosector
