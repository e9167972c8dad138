#pragma once
// What a hand holds, as the server tells.

#include <vector>

#include "client/replica/replica.h"
#include "client/view/blade_frame.h"

namespace prosector {

/// Returns the bodies that the hand holds.
std::vector<BodyId> held_by(const Replica& replica, const HandRef& hand);

/// Returns the tip of the instrument that the hand holds, in the wrist's frame (m): of its points the one
/// farthest ahead. nullopt: it holds none. An instrument is a slender rigid body, neither bone nor tissue.
std::optional<Vec3> instrument_tip(const Replica& replica, const HandRef& hand, double tick);

/// Returns the blade that the hand holds, in the wrist's frame; nullopt: it holds none.
std::optional<BladeFrame> held_blade(const Replica& replica, const HandRef& hand, double tick);

}  // namespace prosector
