#pragma once
// Text list of the cuts, for rewinding.

#include <functional>
#include <map>
#include <string>

#include "common/body_messages.h"
#include "common/ids.h"
#include "common/scene_messages.h"
#include "common/session_messages.h"

namespace prosector {

/// Returns a list of the cuts as text: a line for each body with changed topology, with its newest revision,
/// cause, author and time. `shown` returns the displayed topology revision of a body; null: none.
/// `tick_seconds`: duration of a tick, s.
std::string cut_list_text(const SceneInfo& scene, const std::map<ParticipantId, RosterEntry>& roster,
                          double tick_seconds, const std::function<const TopologyRevision*(BodyId)>& shown);

}  // namespace prosector
