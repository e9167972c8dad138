#pragma once
// Rules for changing parts: attachment, visibility, touchability and stiffness.

#include "server/physics/base/step_report.h"
#include "server/physics/world/state.h"

namespace prosector {

/// Applies the event, or returns the reason why not.
Refusal obey(State& state, const PartEvent& event, StepReport& report);
/// Resets the body to its state in the scene, at rest, and undoes all changes by participants. A broken bone
/// is restored.
void reset_body(State& state, BodyId body, StepReport& report);
/// Moves the body to its start in the scene, at rest; tissue to its equilibrium.
void put_at_start(Bodies& bodies, BodyId body);

}  // namespace prosector
