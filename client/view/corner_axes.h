#pragma once
// The axes of the room, or of the patient in it, in a corner of the user's own view.

#include <optional>

#include "client/view/draw_list.h"
#include "common/appearance.h"

namespace prosector {

/// Adds three labelled axes, as they are oriented for `camera`, to the lower left corner of every view.
/// Without a patient, they are the world's x, y and z. With one, they are the patient's: R to L (right,
/// left), A to P (anterior, posterior) and S to I (superior, inferior).
void add_corner_axes(DrawList& list, const std::optional<PatientFrame>& patient, const DrawCamera& camera);

}  // namespace prosector
