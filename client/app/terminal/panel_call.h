#pragma once
// Selects the panel for a user's panel request.

#include <optional>

#include "client/replica/replica.h"

namespace prosector {

/// Returns the command: closes the user's own panel if it is open, else opens that of the part that the hand
/// touches, else that of `pointed_at`. Returns nullopt if none applies.
std::optional<CommandBody> call_panel(const Replica& replica, ParticipantId user, std::size_t hand,
                                      std::optional<BodyId> pointed_at);

}  // namespace prosector
