#pragma once
// The first phase of a tick: inputs of participants and programs.

#include "server/physics/base/step_report.h"
#include "server/physics/stations/touching/colliders.h"
#include "server/physics/world/state.h"
#include "server/physics/world/tick_input.h"

namespace prosector {

/// Applies the tick's inputs to the state: hand events (appear, vanish, grasp, release), hand targets, and
/// events of anatomical parts, panels and kinematic bodies. Then bends the fingers. Updates `colliders` if a
/// hand needs nearby bodies.
void take_inputs(State& state, Colliders& colliders, const TickInput& input, StepReport& report);

}  // namespace prosector
