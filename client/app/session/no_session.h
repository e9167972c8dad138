#pragma once
// Error text for a user whose session was not found.

#include <chrono>
#include <span>
#include <string>

#include "idl/bus.h"

namespace prosector {

/// Returns whether the session that the configuration names is among the sessions found on the network.
bool is_among(const BusConfig& config, std::span<const SessionInfo> found);

/// Returns an error text on why the session was not joined within `time_limit`, and what the user can do. If
/// the session runs but does not answer, the advice is a longer timeout; otherwise to start the session or to
/// choose one of `found`.
std::string session_not_found_text(const BusConfig& config, std::chrono::milliseconds time_limit,
                                   std::span<const SessionInfo> found);

}  // namespace prosector
