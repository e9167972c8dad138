#pragma once
// The people of a recorded session, as clients are told where they are.

#include <vector>

#include "server/session/recording_index.h"

namespace prosector {

/// Returns everyone of `people` who took part, as the simulation has their hands. A journal keeps where eyes
/// are, not where they look: the head is turned to the hands. Who has no hands in the room, or whose eyes are
/// not known, has no head. Times are the simulation's.
std::vector<UserState> recorded_users(const Simulation& simulation, const Roster& people,
                                      const RecordingIndex& index);

}  // namespace prosector
