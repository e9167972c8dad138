#pragma once
// What soft bodies may touch that is not soft.

#include <span>
#include <vector>

#include "server/physics/bodies.h"
#include "server/physics/contact/surface_detector.h"
#include "server/physics/hands/hand.h"
#include "server/physics/organs/blade.h"

namespace prosector {

/// All colliders by slot, then the sides of the room. What is absent has no parts.
using Colliders = std::vector<Collider>;

/// Makes the list anew: where everything is now, and which instruments are held by their blades.
void refresh(Colliders& colliders, const Bodies& bodies, std::span<const Hand> hands,
             std::span<const Blade> blades);

/// Returns how fast any point of the collider may be, m/s.
double total_speed(const Collider& collider);

}  // namespace prosector
