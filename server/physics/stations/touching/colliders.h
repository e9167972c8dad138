#pragma once
// All rigid colliders that soft bodies may touch.

#include <span>
#include <vector>

#include "server/physics/mechanics/contact/surface_detector.h"
#include "server/physics/mechanics/hands/hand.h"
#include "server/physics/mechanics/organs/blade.h"
#include "server/physics/world/bodies.h"

namespace prosector {

/// All colliders by slot, then the sides of the room. Absent bodies have no parts.
using Colliders = std::vector<Collider>;

/// Rebuilds the list: current poses, and which instruments are held as blades.
void refresh(Colliders& colliders, const Bodies& bodies, std::span<const Hand> hands,
             std::span<const Blade> blades);

/// Returns an upper bound of the speed of any point of the collider, m/s.
double total_speed(const Collider& collider);

}  // namespace prosector
