#pragma once
// A panel under the finger of a hand that an arm moves. Its board stops the finger. A button's spring gives
// way to where it is home, and the stop there is the click.

#include <vector>

#include "common/contact_plane.h"
#include "common/messages.h"

namespace prosector {

/// Returns what the index finger's tip meets of an open panel, or is about to. `pose`: of the hand as physics
/// has it.
std::vector<ContactPlane> panel_planes(const Panel& panel, std::size_t hand, const HandPose& pose);

}  // namespace prosector
