#pragma once
// Puts islands to sleep in which nothing moves.

#include <vector>

#include "server/physics/mechanics/coupled/island.h"
#include "server/physics/world/state.h"

namespace prosector {

/// Puts islands (sets of bodies that were solved together in the last tick) to sleep if all their bodies have
/// been quiet long enough, and keeps the others awake. Moves the contact surfaces of all their soft bodies to
/// the current node positions. `driven`: whether kinematic bodies (on prescribed trajectories) move and may
/// move others.
void update_sleep(State& state, std::vector<coupled::Island>& islands, bool driven);

}  // namespace prosector
