#pragma once
// Overlay of a session: statistics, the room's axes, and the body that the user touches.

#include "client/replica/replica.h"
#include "client/view/draw_list.h"
#include "client/view/view_settings.h"

namespace prosector {

/// Returns the roster entry of the participant with this name, preferring active participants to observers;
/// null if there is none.
const RosterEntry* find_by_name(const Replica& replica, const std::string& name);

/// Returns a body's name with the names of the participants that hold it: "scalpel, held by Ann".
std::string named_with_holders(const Replica& replica, BodyId body, const Catalogue& words = {});

void add_session_overlay(DrawList& list, const Replica& replica, const LocalUser& self,
                         const ViewSettings& settings);

}  // namespace prosector
