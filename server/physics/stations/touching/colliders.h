#pragma once
// All rigid colliders that soft bodies may touch.

#include <span>
#include <vector>

#include "server/physics/mechanics/contact/surface_detector.h"
#include "server/physics/mechanics/hands/hand.h"
#include "server/physics/mechanics/organs/blade.h"
#include "server/physics/world/bodies.h"

namespace prosector {

/// All rigid bodies and hands that soft bodies may touch, by slot (index) in the rigid world, then the sides
/// of the room. Bodies that can't be touched now have no shape parts.
using Colliders = std::vector<contact::Collider>;

/// Rebuilds the list of colliders from the bodies' current poses, and marks the instruments that hands hold
/// as blades.
void refresh(Colliders& colliders, const Bodies& bodies, std::span<const hands::Hand> hands,
             std::span<const organs::Blade> blades);

/// Returns an upper bound of the speed (m/s) of any point of the collider, from its linear and angular
/// velocity.
double total_speed(const contact::Collider& collider);

}  // namespace prosector
