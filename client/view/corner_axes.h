#pragma once
// The directions of the room, or of the patient in it, in a corner of the user's own view.

#include <optional>

#include "client/view/draw_list.h"
#include "common/messages.h"

namespace prosector {

/// Adds three axes as `camera` sees their directions, in the lower left corner of every view. They are the
/// world's x, y and z. If there is a patient, they are theirs instead: R to L (right, left), A to P
/// (anterior, posterior) and S to I (superior, inferior).
void add_corner_axes(DrawList& list, const std::optional<PatientFrame>& patient, const DrawCamera& camera);

}  // namespace prosector
