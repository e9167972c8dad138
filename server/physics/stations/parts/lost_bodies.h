#pragma once
// Recovery of hands with an invalid pose, and of bodies that left the room.

#include <span>

#include "server/physics/base/step_report.h"
#include "server/physics/mechanics/coupled/island.h"
#include "server/physics/world/state.h"

namespace prosector {

/// Moves hands with an invalid pose back to their last good poses, by slot, stops them, and reports it.
void recover_hands(State& state, std::span<const RigidMotion> last_good, StepReport& report);
/// Moves bodies that left the room back to their start, and reports it. `islands`: of the tick.
void return_lost_bodies(State& state, std::span<const Island> islands, StepReport& report);

}  // namespace prosector
