#pragma once
// What was cut, for whoever wants to rewind to it.

#include <functional>
#include <map>
#include <string>

#include "common/messages.h"

namespace prosector {

/// Returns a line for each body that something was done to: its newest revision, what made it, who and when.
/// `shown` returns the revision of a body that is shown; null: none.
std::string told_cuts(const SceneInfo& scene, const std::map<ParticipantId, RosterEntry>& roster,
                      double tick_seconds, const std::function<const TopologyRevision*(BodyId)>& shown);

}  // namespace prosector
