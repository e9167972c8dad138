#pragma once
// Going back to an earlier state. The logs of cuts go on, so revisions and ids never repeat; the hands that
// are there stay where they are, holding nothing.

#include "server/physics/base/step_report.h"
#include "server/physics/world/state.h"

namespace prosector {

/// Rewinds the simulation to the saved state of the event. If that is impossible, returns the reason; then
/// nothing has changed.
Refusal rewind(State& state, const CutEvent& event, StepReport& report);

}  // namespace prosector
