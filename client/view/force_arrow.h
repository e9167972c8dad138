#pragma once
// Arrow of the contact force on a hand, for users without a haptic device.

#include "client/view/draw_list.h"

namespace prosector {

/// Adds an arrow that shows the contact force on a hand. It starts at the contact point (m, world frame) and
/// points along the force (N). Its length is proportional to the force up to a maximum; very small forces
/// have no arrow.
void add_force_arrow(DrawList& list, const Vec3& point, const Vec3& force);

}  // namespace prosector
