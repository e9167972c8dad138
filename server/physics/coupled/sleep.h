#pragma once
// Islands in which nothing moves any more go to sleep, whole.

#include <vector>

#include "server/physics/island.h"
#include "server/physics/state.h"

namespace prosector {

/// Puts islands of the last tick to sleep whose bodies have been quiet long enough, and keeps the others
/// awake. Takes the surfaces of all their soft bodies to where these are. `driven`: something is, and may be
/// what moves others.
void fall_asleep(State& state, std::vector<Island>& islands, bool driven);

}  // namespace prosector
