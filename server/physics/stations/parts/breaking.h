#pragma once
// Fracture of bones in a tick.

#include <span>

#include "server/physics/base/step_report.h"
#include "server/physics/mechanics/coupled/island.h"
#include "server/physics/stations/touching/colliders.h"
#include "server/physics/world/state.h"

namespace prosector {

/// Breaks bones in which the force through a fracture plane exceeded its limit in the last h s, and reports
/// it. `islands` (sets of bodies solved together) and `colliders` are those of the same time span.
void break_bones(State& state, std::span<const coupled::Island> islands,
                 std::span<const contact::Collider> colliders, double h, StepReport& report);

}  // namespace prosector
