#pragma once
// Grasping of bodies by hands.

#include <optional>

#include "server/physics/stations/touching/colliders.h"
#include "server/physics/world/state.h"

namespace prosector {

/// Grasps the wanted body if the hand reaches it. Otherwise grasps the nearest body that its touches can
/// hold, rigid bodies first. Does nothing if the hand already holds a body. Refreshes `colliders`.
void grasp(State& state, Colliders& colliders, Hand& hand, std::optional<BodyId> wanted = std::nullopt);

/// Grasps that body if the hand reaches it. Refreshes `colliders`.
void grasp_only(State& state, Colliders& colliders, Hand& hand, BodyId wanted);

}  // namespace prosector
