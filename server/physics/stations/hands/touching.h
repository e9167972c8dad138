#pragma once
// Contacts, holds and weights that are rendered on a haptic arm. A rigid body in a hand counts as part of the
// hand.

#include <span>
#include <vector>

#include "server/physics/mechanics/coupled/island.h"
#include "server/physics/stations/touching/colliders.h"
#include "server/physics/world/state.h"
#include "server/physics/world/tick_output.h"

namespace prosector {

/// Returns what surrounds a hand after a tick, for a haptic arm. `touches` begins with the tick's contacts,
/// holds and cut points of the hand. Then follow the nearest points of other tissue within `reach` (m), one
/// per body, and the weight of a held rigid body. `supports` has the contacts and holds of the soft bodies in
/// `touches`.
HandSurroundings surroundings_of(const State& state, std::span<const coupled::Island> islands,
                                 std::span<const contact::Collider> colliders, const HandRef& hand,
                                 double reach);

}  // namespace prosector
