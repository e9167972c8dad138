#pragma once
// How a body is solved, as its panel's strips show it.

#include <optional>

#include "client/replica/replica.h"
#include "client/view/effort_strip.h"

namespace prosector {

/// Returns how a body is solved; nullopt: it is rigid, or not told yet. `viewer`: who sees it.
std::optional<ShownEffort> shown_effort(const Replica& replica, BodyId body, ParticipantId viewer);

}  // namespace prosector
