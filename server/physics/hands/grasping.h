#pragma once
// How a hand takes hold of something.

#include <optional>

#include "server/physics/contact/colliders.h"
#include "server/physics/state.h"

namespace prosector {

/// Lets the hand hold the body that is wanted, if it reaches that; else the nearest that its touches can
/// hold, rigid ones first. A hand that holds something already keeps it. Refreshes `colliders`.
void grasp(State& state, Colliders& colliders, Hand& hand, std::optional<BodyId> wanted = std::nullopt);

/// Lets the hand hold that body if it reaches it, else nothing. Refreshes `colliders`.
void grasp_only(State& state, Colliders& colliders, Hand& hand, BodyId wanted);

}  // namespace prosector
