#pragma once
// Converts events of a session to lines of text.

#include <string>

#include "server/session/people/session.h"

namespace prosector {

/// Returns an event as a line of text.
std::string line_of(const SessionEvent& event);

}  // namespace prosector
