#pragma once
// Going back to an earlier state. The logs of cuts go on, so revisions and ids never repeat; the hands that
// are there stay where they are, holding nothing.

#include "server/physics/base/step_report.h"
#include "server/physics/world/state.h"

namespace prosector {

/// Goes back, or returns why not; then nothing changed but caches, which are made anew.
Refusal rewind(State& state, const CutEvent& event, StepReport& report);

}  // namespace prosector
