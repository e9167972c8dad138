#pragma once
// What is laid over a picture of a session: its figures, the room's axes, and what the user touches.

#include "client/replica/replica.h"
#include "client/view/draw_list.h"
#include "client/view/view_settings.h"

namespace prosector {

/// Finds the participant of this name, one who takes part before one who watches; null: nobody has it.
const RosterEntry* find_by_name(const Replica& replica, const std::string& name);

/// Returns what a body of the scene is called, and who holds it: "scalpel, held by Ann".
std::string named_with_holders(const Replica& replica, BodyId body, const Catalogue& words = {});

void add_session_overlay(DrawList& list, const Replica& replica, const LocalUser& self,
                         const ViewSettings& settings);

}  // namespace prosector
