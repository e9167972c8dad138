#pragma once
// Solver effort of a body, for its panel's strips.

#include <optional>

#include "client/replica/replica.h"
#include "client/view/effort_strip.h"

namespace prosector {

/// Returns the solver effort of a body; nullopt: it is rigid, or its status was not received yet. `viewer`:
/// the participant to show it to.
std::optional<ShownEffort> shown_effort(const Replica& replica, BodyId body, ParticipantId viewer);

}  // namespace prosector
