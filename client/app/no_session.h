#pragma once
// What to tell a user who was not let into a session because it was not found.

#include <chrono>
#include <span>
#include <string>

#include "idl/bus.h"

namespace prosector {

/// Tells whether the session that is looked for is among those that were found.
bool is_among(const BusConfig& config, std::span<const SessionInfo> found);

/// Returns why the session was not joined after `patience`, and what to do: start it, or choose one of those
/// that were found. Where it runs but does not answer: wait for longer.
std::string no_session_text(const BusConfig& config, std::chrono::milliseconds patience,
                            std::span<const SessionInfo> found);

}  // namespace prosector
