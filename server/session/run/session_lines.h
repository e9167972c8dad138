#pragma once
// Converts events and the status of a session to lines of text.

#include <string>

#include "common/status_messages.h"
#include "server/session/people/session.h"
#include "server/session/run/body_meter.h"

namespace prosector {

/// Returns an event of the session, such as a join, as a line of text for the log.
std::string line_of(const SessionEvent& event);
/// Returns the server's status as a line of text for the console, with the errors of the soft bodies that are
/// awake. `bodies` has their newest status.
std::string line_of(const ServerStatus& status, const Simulation& simulation, const BodyMeter& bodies);

}  // namespace prosector
