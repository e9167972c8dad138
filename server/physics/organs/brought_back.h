#pragma once
// Pieces that a cut taken back joins again are brought to where they came off, first.

#include <map>

#include "server/physics/organs/organ.h"
#include "server/physics/state.h"
#include "server/physics/step_report.h"

namespace prosector {

using BroughtBack = std::map<std::size_t, Motion>;  // by soft body

/// Returns how those that go back go on: all others as they did.
BroughtBack brought_back(const Bodies& bodies, const Organ& organ, const Regrouped& changed);
/// Returns how the body was before a change.
const Motion& motion_before(const Bodies& bodies, std::size_t body, const BroughtBack& back);
/// Makes hands let go of what was brought back: a hand doesn't go with it.
void leave_what_went_back(State& state, const BroughtBack& back, StepReport& report);

}  // namespace prosector
