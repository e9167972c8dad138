#pragma once
// Collects the session state that the desk needs from the replica and from the view's last draw list.

#include "client/app/desk/desk.h"
#include "client/replica/replica.h"
#include "client/view/scene_view.h"

namespace prosector {

/// Returns the initial view of the user `self` for a frame of this aspect ratio (width over height). The
/// anatomy fills the frame, and the direction differs from the present views of other users.
DeskStart start_view_of(Replica& replica, double tick, ParticipantId self, double aspect);

/// Returns the session state that the desk (mouse and keyboard control) of the user `self` needs for the next
/// frame. `view` must outlive it. The caller fills in the rows of the parts list and the display scale.
DeskSession desk_session(const Replica& replica, SceneView& view, double tick, ParticipantId self);

/// Sets in `settings` the display options that the user has chosen with mouse and keyboard, and the pointer.
/// The caller sets the camera.
void show_choices(const Desk& desk, Outlook& settings);

}  // namespace prosector
