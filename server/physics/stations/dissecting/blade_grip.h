#pragma once
// Ties between tissue and the points of a blade's edges.

#include <vector>

#include "server/physics/mechanics/organs/blade.h"
#include "server/physics/world/state.h"

namespace prosector {

/// Returns the positions of a held instrument's edge points, m, world frame.
std::vector<Vec3> edge_points(const Bodies& bodies, std::size_t slot);

/// Updates the list of blades that hands hold, lists the ties of their points with tissue, and wakes that
/// tissue.
void grip_blades(State& state, std::vector<BladeGrip>& grips);

}  // namespace prosector
