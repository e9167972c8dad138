#pragma once
// What the desk is told of a session, made from the replica and the list that the view built last.

#include "client/app/desk.h"
#include "client/replica/replica.h"
#include "client/view/scene_view.h"

namespace prosector {

/// Returns the start of `self` in a picture of that aspect (width over height): the anatomy in the picture,
/// and a seat that no other user has.
DeskStart seat_of(Replica& replica, double tick, ParticipantId self, double aspect);

/// Returns what the desk of `self` knows for the next picture. The view outlives it. The rows of the list of
/// parts and the display's scale are the caller's to fill in.
DeskSession desk_session(const Replica& replica, SceneView& view, double tick, ParticipantId self);

/// Sets what mouse and keyboard chose to see, and where the pointer is. The eye is the caller's to set.
void show_choices(const Desk& desk, ViewSettings& settings);

}  // namespace prosector
