#pragma once
// Undo of cuts and rewind to a saved state, as requested by participants.

#include <span>

#include "server/physics/base/step_report.h"
#include "server/physics/world/state.h"

namespace prosector {

/// Applies the events in order and answers them in StepReport::cut_answers. Returns whether the state was
/// rewound; the tick's islands then belong to another state.
bool apply_cut_events(State& state, std::span<const CutEvent> events, StepReport& report);

}  // namespace prosector
