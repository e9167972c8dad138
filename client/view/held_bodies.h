#pragma once
// Bodies that a hand holds, as reported by the server.

#include <vector>

#include "client/replica/replica.h"
#include "client/view/blade_frame.h"

namespace prosector {

/// Returns the bodies that the server reports as held by the participant's hand.
std::vector<BodyId> held_by(const Replica& replica, const HandRef& hand);

/// Returns the position, in the wrist's frame, m, of the tip of the instrument that the hand holds at `tick`
/// (simulation step): its vertex farthest ahead. An instrument is a slender rigid body, neither bone nor
/// tissue. Returns nullopt if the hand holds none.
std::optional<Vec3> instrument_tip(const Replica& replica, const HandRef& hand, double tick);

/// Returns the geometry of the blade that the hand holds at `tick` (simulation step), in the wrist's frame.
/// Returns nullopt if the hand holds no blade.
std::optional<BladeFrame> held_blade(const Replica& replica, const HandRef& hand, double tick);

}  // namespace prosector
