#pragma once
// Selects the panel for a user's panel request.

#include <optional>

#include "client/replica/replica.h"

namespace prosector {

/// Returns the command to the server for a user's panel request. It closes the user's own panel if one is
/// open. Otherwise it opens that of the part that the hand touches, else that of `pointed_at`. Returns
/// nullopt if none applies.
std::optional<CommandBody> call_panel(const Replica& replica, ParticipantId user, std::size_t hand,
                                      std::optional<BodyId> pointed_at);

}  // namespace prosector
