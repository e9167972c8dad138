#pragma once
// Points of a scene's anatomy, which the initial view is fitted to.

#include "client/replica/replica.h"

namespace prosector {

/// Returns vertices (m, world frame, rest pose) of the soft bodies and of the parts near them. Without soft
/// bodies or parts: those of the movable bodies; empty if no body moves.
std::vector<Vec3> anatomy_points(Replica& replica);

}  // namespace prosector
