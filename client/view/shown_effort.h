#pragma once
// Solver effort of a body, for its panel's strips.

#include <optional>

#include "client/replica/replica.h"
#include "client/view/effort_strip.h"

namespace prosector {

/// Returns the solver effort of a soft body, for the panel of its part. Returns nullopt if the body is rigid,
/// or if its status was not received yet. `viewer`: the participant to which it is shown, as only the host
/// may choose a model configuration.
std::optional<ShownEffort> shown_effort(const Replica& replica, BodyId body, ParticipantId viewer);

}  // namespace prosector
