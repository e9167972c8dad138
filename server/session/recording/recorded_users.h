#pragma once
// States of the users of a recorded session, as published to clients.

#include <vector>

#include "server/session/recording/recording_index.h"

namespace prosector {

/// Returns the state of every participant of `people` in a recording, with its simulated hands. A journal
/// stores the positions of eyes, but not their direction, so the head faces the hands. A participant without
/// hands in the room, or with an unknown eye position, has no head. Times are the simulation's.
std::vector<UserState> recorded_users(const Simulation& simulation, const Roster& people,
                                      const RecordingIndex& index);

}  // namespace prosector
