#pragma once
// Rules for changing parts: attachment, visibility, touchability and stiffness.

#include "server/physics/base/step_report.h"
#include "server/physics/world/state.h"

namespace prosector {

/// Applies a participant's action on an anatomical part to the state. Returns the reason if the action is not
/// allowed.
Refusal obey(State& state, const PartEvent& event, StepReport& report);
/// Resets the body to its initial state in the scene, at rest, and undoes all changes that participants made
/// to it. A broken bone is restored.
void reset_body(State& state, BodyId body, StepReport& report);
/// Moves the body to its initial position in the scene, at rest. A soft body is moved to its equilibrium
/// under gravity.
void put_at_start(Bodies& bodies, BodyId body);

}  // namespace prosector
