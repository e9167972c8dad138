#pragma once
// Recovery of hands with an invalid pose, and of bodies that left the room.

#include <span>

#include "server/physics/base/step_report.h"
#include "server/physics/mechanics/coupled/island.h"
#include "server/physics/world/state.h"

namespace prosector {

/// Moves each hand whose pose is not finite or too far away back to its last good pose, stops it, and reports
/// it. `last_good` has the motions from before the solve, by slot (index) in the rigid world.
void recover_hands(State& state, std::span<const rigid::RigidMotion> last_good, StepReport& report);
/// Moves bodies that left the room back to their initial position, and reports it. Soft bodies are checked
/// only if they are in `islands` (sets of bodies solved together in the tick), since the others sleep.
void return_lost_bodies(State& state, std::span<const coupled::Island> islands, StepReport& report);

}  // namespace prosector
