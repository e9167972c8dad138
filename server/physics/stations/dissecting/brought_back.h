#pragma once
// Pieces that an undo rejoins are first moved back to where they were cut off.

#include <map>

#include "server/physics/base/step_report.h"
#include "server/physics/mechanics/organs/organ.h"
#include "server/physics/world/state.h"

namespace prosector {

using BroughtBack = std::map<std::size_t, Motion>;  // by soft body

/// Returns the new motion of the pieces that move back; other pieces keep their motion.
BroughtBack brought_back(const Bodies& bodies, const Organ& organ, const Regrouped& changed);
/// Returns the body's motion before a change, after moving back if it does.
const Motion& motion_before(const Bodies& bodies, std::size_t body, const BroughtBack& back);
/// Releases bodies that were moved back from hands, since hands don't move with them.
void leave_what_went_back(State& state, const BroughtBack& back, StepReport& report);

}  // namespace prosector
