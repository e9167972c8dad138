#pragma once
// What a hand meets, and what bears the tissue that it meets: what those are told who feel with an arm.

#include <span>
#include <vector>

#include "server/physics/contact/colliders.h"
#include "server/physics/island.h"
#include "server/physics/state.h"

namespace prosector {

/// Returns the points that press on the hand in the tick's islands, then those of tissue that are nearer than
/// `reach` (m) and don't, the nearest of each body.
std::vector<HandTouch> touches_of(const State& state, std::span<const Island> islands,
                                  std::span<const Collider> colliders, const HandRef& hand, double reach);
/// Returns what presses on a soft body in the tick's islands, or holds it.
std::vector<Support> supports_of(const State& state, std::span<const Island> islands, BodyId soft_body);

}  // namespace prosector
