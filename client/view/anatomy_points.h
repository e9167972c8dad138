#pragma once
// Points of a scene's anatomy, which the initial view is fitted to.

#include "client/replica/replica.h"

namespace prosector {

/// Returns vertices (m, world frame, rest pose) of the soft bodies and of the anatomical parts within 0.3 m
/// of them, to which the initial view is fitted. Without soft bodies, those of all parts; without either,
/// those of the movable bodies. Empty if no body moves.
std::vector<Vec3> anatomy_points(Replica& replica);

}  // namespace prosector
