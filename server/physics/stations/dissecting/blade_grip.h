#pragma once
// Ties between tissue and the points of a blade's edges.

#include <vector>

#include "server/physics/mechanics/organs/blade.h"
#include "server/physics/world/state.h"

namespace prosector {

/// Returns the current positions (m, world frame) of the points on the cutting edges of a held instrument.
/// `slot` is its index in the rigid world.
std::vector<Vec3> edge_points(const Bodies& bodies, std::size_t slot);

/// Updates the list of instruments with cutting edges that hands hold. Fills `grips` with the ties between
/// points of their edges and tissue, and wakes that tissue.
void grip_blades(State& state, std::vector<organs::BladeGrip>& grips);

}  // namespace prosector
