#pragma once
// What is lost: a hand that went where no pose is, and bodies that left the room.

#include <span>

#include "server/physics/island.h"
#include "server/physics/state.h"
#include "server/physics/step_report.h"

namespace prosector {

/// Stops hands that went where no pose is at their last good places, by slot, and says so.
void recover_hands(State& state, std::span<const RigidMotion> last_good, StepReport& report);
/// Puts bodies that left the room back where they began, and says so. `islands`: of the tick.
void bring_back_lost(State& state, std::span<const Island> islands, StepReport& report);

}  // namespace prosector
