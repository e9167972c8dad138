#pragma once
// Appearance and disappearance of hands, and release of held bodies.

#include <string>
#include <vector>

#include "server/physics/base/step_report.h"
#include "server/physics/world/state.h"

namespace prosector {

/// Returns an iterator to the participant's hand of that side (left or right), or hands.end() if it is not
/// present.
std::vector<hands::Hand>::iterator find_hand(std::vector<hands::Hand>& hands, ParticipantId participant,
                                             std::size_t side);
/// Adds a participant's hand of that side (left or right) to the simulation, at the room's origin.
void appear(State& state, ParticipantId participant, std::size_t side);
void vanish(State& state, std::vector<hands::Hand>::iterator hand, StepReport& report);
/// Releases the body that the hand holds, if any, and reports the reason `why`.
void release(Bodies& bodies, hands::Hand& hand, const std::string& why, StepReport& report);
/// Releases the body from all hands that hold it, and reports the reason `why`.
void let_go_of(State& state, BodyId body, const char* why, StepReport& report);
/// Adds the hand's physical body, with its current finger flexion, to a rigid world. Returns its slot (index)
/// there.
std::size_t add_hand(const Model& model, rigid::RigidWorld& world, const hands::Hand& hand,
                     const rigid::RigidMotion& motion);

}  // namespace prosector
