#pragma once
// What happens in a session, as lines for people.

#include <string>

#include "server/session/session.h"

namespace prosector {

/// Returns an event in words.
std::string line_of(const SessionEvent& event);

}  // namespace prosector
