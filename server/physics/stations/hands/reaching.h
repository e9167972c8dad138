#pragma once
// Contacts that a fast hand or the tool in it makes within the tick, so that they don't pass through thin
// bodies.

#include <span>
#include <vector>

#include "server/physics/mechanics/rigid/rigid_world.h"
#include "server/physics/stations/touching/colliders.h"
#include "server/physics/world/state.h"

namespace prosector {

/// Returns the contacts that hands and held rigid bodies make within the tick's h s on their way to the
/// hands' targets. Contacts that they have at the tick's start are not included. Parts of them slide along
/// what they already touch, and bodies are taken to stand still. Each contact has the normal of the first
/// touch and the gap (m) along that normal at the tick's start. The hand or held body is side a; world frame.
/// Of held bodies, the long edges of boxes, spheres, capsules and cylinders count.
std::vector<rigid::RigidContact> reached_bodies(const Bodies& bodies,
                                                std::span<const contact::Collider> colliders,
                                                std::span<const hands::Hand> hands, double h);

}  // namespace prosector
