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

/// Adds contacts, energies, and the numbers of awake and sleeping bodies to the report.
void describe(State& state, std::span<const Island> islands, StepReport& report);

/// Returns the pose of each hand and its strongest contact. `islands` and `colliders`: of the last h s.
std::vector<HandState> describe_hands(const State& state, std::span<const Island> islands,
                                      std::span<const Collider> colliders, double h);

/// Returns the exchanges of `earlier` plus those of the last h s, computed from `islands`.
std::vector<Exchange> exchanges(std::vector<Exchange> earlier, std::span<const Island> islands,
                                std::size_t rigid_bodies, double h);

}  // namespace prosector
