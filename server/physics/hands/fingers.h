#pragma once
// Fingers bend towards where they are tracked, and stop on what resists.

#include "server/physics/contact/colliders.h"
#include "server/physics/state.h"

namespace prosector {

/// Bends all hands' fingers for one tick. Refreshes `colliders` unless all are straight and stay so.
void bend_fingers(State& state, Colliders& colliders);

}  // namespace prosector
