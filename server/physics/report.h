#pragma once
// What a tick did, and where the hands are.

#include <span>
#include <vector>

#include "server/physics/contact/colliders.h"
#include "server/physics/island.h"
#include "server/physics/simulation.h"
#include "server/physics/state.h"

namespace prosector {

/// Adds contacts, energies and how many bodies sleep to the report.
void describe(State& state, std::span<const Island> islands, StepReport& report);

/// Returns where each hand is and what it touches most. `islands` and `colliders`: of the last h s.
std::vector<HandState> describe_hands(const State& state, std::span<const Island> islands,
                                      std::span<const Collider> colliders, double h);

/// Returns what bodies did to each other: what `earlier` says, and what they did in the last h s, whose
/// islands these are.
std::vector<Exchange> exchanges(std::vector<Exchange> earlier, std::span<const Island> islands,
                                std::size_t rigid_bodies, double h);

}  // namespace prosector
