#pragma once
// The first phase of a tick: what people and programs ask for.

#include "server/physics/contact/colliders.h"
#include "server/physics/simulation.h"
#include "server/physics/state.h"

namespace prosector {

/// Makes hands appear, move their targets, bend, take hold and let go; obeys what is said of parts, panels
/// and kinematic bodies. Refreshes `colliders` where a hand has to know what is near.
void take_inputs(State& state, Colliders& colliders, const TickInput& input, StepReport& report);

}  // namespace prosector
