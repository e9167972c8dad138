#pragma once
// Contact planes of a panel under the index finger of a hand that a haptic arm moves. The board stops the
// finger. A button has two planes: its spring, and the stop at the end of its travel, which is felt as the
// click.

#include <vector>

#include "common/contact_plane.h"
#include "common/hand_pose.h"
#include "common/part_messages.h"

namespace prosector {

/// Returns the contact planes of an open control panel that the tip of the index finger touches, or is about
/// to touch. `hand` is the side of the hand, and `pose` its simulated pose.
std::vector<ContactPlane> panel_planes(const Panel& panel, std::size_t hand, const HandPose& pose);

}  // namespace prosector
