#pragma once
// Undo of cuts and rewind to a saved state, as requested by participants.

#include <span>

#include "server/physics/base/step_report.h"
#include "server/physics/world/state.h"

namespace prosector {

/// Applies participants' requests to undo cuts or to rewind, in order, and appends an answer to each to
/// StepReport::cut_answers. Returns whether the state was rewound. In that case, the islands (sets of bodies
/// solved together) of this tick no longer belong to the state.
bool apply_cut_events(State& state, std::span<const CutEvent> events, StepReport& report);

}  // namespace prosector
