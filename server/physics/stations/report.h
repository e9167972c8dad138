#pragma once
// Report of a tick, and states of the hands.

#include <span>
#include <vector>

#include "server/physics/base/step_report.h"
#include "server/physics/mechanics/coupled/island.h"
#include "server/physics/stations/touching/colliders.h"
#include "server/physics/world/state.h"
#include "server/physics/world/tick_output.h"

namespace prosector {

/// Adds the number of contacts, the energies, and the numbers of awake and sleeping bodies to the report.
void describe(State& state, std::span<const coupled::Island> islands, StepReport& report);

/// Returns the pose of each hand and its strongest contact, in the order of the state's hands. `islands`
/// (sets of bodies solved together) and `colliders` are those of the last h s.
std::vector<HandState> describe_hands(const State& state, std::span<const coupled::Island> islands,
                                      std::span<const contact::Collider> colliders, double h);

/// Returns the exchanges (impulse, depth and contact point of each pair of bodies) in `earlier`, combined
/// with those of the last h s. The latter are computed from `islands` (sets of bodies solved together).
/// `rigid_bodies` is the number of rigid bodies.
std::vector<Exchange> exchanges(std::vector<Exchange> earlier, std::span<const coupled::Island> islands,
                                std::size_t rigid_bodies, double h);

}  // namespace prosector
