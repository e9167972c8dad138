#pragma once
// How a hand takes hold of something.

#include "server/physics/contact/colliders.h"
#include "server/physics/state.h"

namespace prosector {

/// Lets the hand hold the nearest body within its reach that its touches can hold, rigid ones first, unless
/// it holds one already. Refreshes `colliders`.
void grasp(State& state, Colliders& colliders, Hand& hand);

}  // namespace prosector
