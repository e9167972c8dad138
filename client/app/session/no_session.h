#pragma once
// Error text for a user whose session was not found.

#include <chrono>
#include <span>
#include <string>

#include "idl/bus.h"

namespace prosector {

/// Reports whether the configured session is among the discovered ones.
bool is_among(const BusConfig& config, std::span<const SessionInfo> found);

/// Returns why the session was not joined within `patience`, and what the user can do. If the session runs
/// but does not answer, the advice is a longer timeout; else to start it or to choose a discovered one.
std::string session_not_found_text(const BusConfig& config, std::chrono::milliseconds time_limit,
                                   std::span<const SessionInfo> found);

}  // namespace prosector
