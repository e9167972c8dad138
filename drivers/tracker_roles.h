#pragma once
// Which of a tracker's stations has which role, where its driver knows some by itself, and by which device a
// role is seen.

#include <string>

#include "drivers/client_config.h"

namespace prosector {

/// Gives roles the stations at which the tracker's driver tells them, whatever was written. A driver that
/// knows hands tells them at stations 1 and 2, and other roles follow; one that knows the head at station 1.
void settle_roles(ClientConfig& config);

/// Returns the address at which a tracker's boards are seen: those before bare hands' camera by `tags`.
std::string boards_address(const std::string& tracker);

/// Returns the configuration with the tracker that sees a role, and the station at which it does. A role that
/// wears a board beside bare hands keeps the station that was written.
ClientConfig seen_for(ClientConfig config, StationRole role);

}  // namespace prosector
