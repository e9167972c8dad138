#pragma once
// Going back to an earlier state. The logs of cuts go on, so revisions and ids never repeat; the hands that
// are there stay where they are, holding nothing.

#include "server/physics/base/step_report.h"
#include "server/physics/world/state.h"

namespace prosector {

/// Rewinds the state, or returns the reason why not; then nothing has changed except rebuilt caches.
Refusal rewind(State& state, const CutEvent& event, StepReport& report);

}  // namespace prosector
