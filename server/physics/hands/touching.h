#pragma once
// Contacts, holds and weight that an arm lets its user feel. A rigid body in a hand counts as the hand.

#include <span>
#include <vector>

#include "server/physics/contact/colliders.h"
#include "server/physics/island.h"
#include "server/physics/state.h"

namespace prosector {

/// Returns the points that press on the hand in the tick's islands, and those that it holds or cuts. Then
/// come those of tissue that are nearer than `reach` (m) and don't, the nearest of each body, and the weight
/// of a rigid body that it holds. With them comes what presses on the soft bodies among these, or holds
/// them.
HandSurroundings surroundings_of(const State& state, std::span<const Island> islands,
                                 std::span<const Collider> colliders, const HandRef& hand, double reach);

}  // namespace prosector
