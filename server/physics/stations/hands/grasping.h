#pragma once
// Grasping of bodies by hands.

#include <optional>

#include "server/physics/stations/touching/colliders.h"
#include "server/physics/world/state.h"

namespace prosector {

/// Makes the hand grasp the body `wanted` if it reaches it. Otherwise it grasps the nearest body that its
/// contact points can hold, rigid bodies first. Does nothing if the hand already holds a body. Updates
/// `colliders` to current poses.
void grasp(State& state, Colliders& colliders, hands::Hand& hand,
           std::optional<BodyId> wanted = std::nullopt);

/// Makes the hand grasp the body `wanted` if it reaches it, and no other body. Does nothing if the hand
/// already holds a body. Updates `colliders` to current poses.
void grasp_only(State& state, Colliders& colliders, hands::Hand& hand, BodyId wanted);

}  // namespace prosector
