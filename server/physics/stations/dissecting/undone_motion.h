#pragma once
// Pieces that an undo rejoins are first moved back to where they were cut off.

#include <map>

#include "server/physics/base/step_report.h"
#include "server/physics/mechanics/organs/organ.h"
#include "server/physics/world/state.h"

namespace prosector {

using UndoneMotion = std::map<std::size_t, soft::Motion>;  // by soft body

/// Returns the new motion of those pieces that an undo of a cut moves back to where they were cut off. Empty
/// for other changes than an undo; pieces that are not in the result keep their motion.
UndoneMotion undone_motion(const Bodies& bodies, const organs::Organ& organ,
                           const organs::Regrouped& changed);
/// Returns the motion that a body has before its mesh is changed: that of `back` if an undo moves the body
/// back first, otherwise its current motion.
const soft::Motion& motion_before(const Bodies& bodies, std::size_t body, const UndoneMotion& back);
/// Releases bodies that an undo has moved back, farther than a hand's grasp reaches, from the hands that hold
/// them, since hands don't move with them.
void release_moved_bodies(State& state, const UndoneMotion& back, StepReport& report);

}  // namespace prosector
