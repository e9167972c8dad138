#pragma once
// Appearance and disappearance of hands, and release of held bodies.

#include <string>
#include <vector>

#include "server/physics/base/step_report.h"
#include "server/physics/world/state.h"

namespace prosector {

/// Returns the participant's hand of that side; end: not present.
std::vector<Hand>::iterator find_hand(std::vector<Hand>& hands, ParticipantId participant, std::size_t side);
/// Adds a hand at the room's origin.
void appear(State& state, ParticipantId participant, std::size_t side);
void vanish(State& state, std::vector<Hand>::iterator hand, StepReport& report);
/// Releases the body that the hand holds, if any, and reports the reason.
void release(Bodies& bodies, Hand& hand, const std::string& why, StepReport& report);
/// Releases the body from all hands.
void let_go_of(State& state, BodyId body, const char* why, StepReport& report);
/// Adds the hand's physical body to a rigid world, with its current flexion. Returns its slot.
std::size_t add_hand(const Model& model, RigidWorld& world, const Hand& hand, const RigidMotion& motion);

}  // namespace prosector
