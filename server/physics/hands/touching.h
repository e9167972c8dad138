#pragma once
// What a hand meets, and what bears the tissue that it meets: what those are told who feel with an arm.

#include <span>
#include <vector>

#include "server/physics/contact/colliders.h"
#include "server/physics/island.h"
#include "server/physics/state.h"

namespace prosector {

/// Returns the points that press on the hand in the tick's islands. Then come those of tissue that are nearer
/// than `reach` (m) and don't, the nearest of each body. With them comes what presses on these bodies, or
/// holds them.
HandSurroundings surroundings_of(const State& state, std::span<const Island> islands,
                                 std::span<const Collider> colliders, const HandRef& hand, double reach);

}  // namespace prosector
