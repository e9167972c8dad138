#pragma once
// A scene's state, taken over into the same scene with some bodies modelled in another way.

#include <string>

#include "common/refusal.h"
#include "server/physics/world/state.h"

namespace prosector {

/// Returns the reason, as text for users, why a body that was cut keeps its model. `body` is its name.
Refusal cut_stays(const std::string& body);

/// Copies the state `from` into `to`, a state of the same scene in which some bodies are modelled
/// differently. Bodies with the same model keep every bit. A soft body with another model gets the old shape
/// and motion: its nodes get the displacements from equilibrium that the old body has at their rest
/// positions. Hands and their panels are not copied. Returns the reason, and changes nothing, if the scenes
/// have other bodies, or a body with another model was cut.
Refusal take_over(const State& from, State& to);

}  // namespace prosector
