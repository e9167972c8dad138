#pragma once
// Fingers bend towards their tracked flexion, and stop at obstacles.

#include "server/physics/stations/touching/colliders.h"
#include "server/physics/world/state.h"

namespace prosector {

/// Bends the fingers of all hands towards their tracked flexion for one tick, and stops them at obstacles.
/// Updates `colliders` unless all fingers are and stay straight.
void bend_fingers(State& state, Colliders& colliders);

}  // namespace prosector
