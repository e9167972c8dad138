#pragma once
// Hands come, go, and let go of what they hold.

#include <string>
#include <vector>

#include "server/physics/state.h"
#include "server/physics/step_report.h"

namespace prosector {

/// Returns the participant's hand of that side; end: it is not there.
std::vector<Hand>::iterator find_hand(std::vector<Hand>& hands, ParticipantId participant, std::size_t side);
/// Makes a hand appear at the room's origin.
void appear(State& state, ParticipantId participant, std::size_t side);
void vanish(State& state, std::vector<Hand>::iterator hand, StepReport& report);
/// Makes the hand let go of what it holds, if anything, and says why.
void release(Bodies& bodies, Hand& hand, const std::string& why, StepReport& report);
/// Makes all hands let go of the body.
void let_go_of(State& state, BodyId body, const char* why, StepReport& report);
/// Adds the hand's physical body to a rigid world, with its fingers bent as they are. Returns its slot.
std::size_t add_hand(const Model& model, RigidWorld& world, const Hand& hand, const RigidMotion& motion);

}  // namespace prosector
