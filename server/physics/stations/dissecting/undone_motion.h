#pragma once
// Pieces that an undo rejoins are first moved back to where they were cut off.

#include <map>

#include "server/physics/base/step_report.h"
#include "server/physics/mechanics/organs/organ.h"
#include "server/physics/world/state.h"

namespace prosector {

using UndoneMotion = std::map<std::size_t, Motion>;  // by soft body

/// Returns the new motion of the pieces that move back; other pieces keep their motion.
UndoneMotion undone_motion(const Bodies& bodies, const Organ& organ, const Regrouped& changed);
/// Returns the body's motion before a change, after moving back if it does.
const Motion& motion_before(const Bodies& bodies, std::size_t body, const UndoneMotion& back);
/// Releases bodies that were moved back from hands, since hands don't move with them.
void release_moved_bodies(State& state, const UndoneMotion& back, StepReport& report);

}  // namespace prosector
