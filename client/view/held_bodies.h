#pragma once
// Bodies that a hand holds, as reported by the server.

#include <vector>

#include "client/replica/replica.h"
#include "client/view/blade_frame.h"

namespace prosector {

/// Returns the bodies that the hand holds.
std::vector<BodyId> held_by(const Replica& replica, const HandRef& hand);

/// Returns the tip of the held instrument, in the wrist's frame (m): its vertex farthest ahead. nullopt: it
/// holds no instrument. An instrument is a slender rigid body, neither bone nor tissue.
std::optional<Vec3> instrument_tip(const Replica& replica, const HandRef& hand, double tick);

/// Returns the held blade, in the wrist's frame; nullopt: the hand holds none.
std::optional<BladeFrame> held_blade(const Replica& replica, const HandRef& hand, double tick);

}  // namespace prosector
