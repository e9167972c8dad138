#pragma once
// Which panel a user who asks for "the panel" means.

#include <optional>

#include "client/replica/replica.h"

namespace prosector {

/// Closes the user's own panel if it is open. Else opens the one of the part that the hand touches or holds,
/// else that of `pointed_at`. Returns nullopt where there is nothing to ask for.
std::optional<Command> call_panel(const Replica& replica, ParticipantId user, std::size_t hand,
                                  std::optional<BodyId> pointed_at);

}  // namespace prosector
