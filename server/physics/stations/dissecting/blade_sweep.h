#pragma once
// Motion of a blade's edges in a tick, with the resistance of tissue.

#include <span>
#include <vector>

#include "server/physics/stations/dissecting/blade_grip.h"
#include "server/physics/world/bodies.h"

namespace prosector {

/// Motion of the points on a blade's cutting edges in a tick, m, world frame, by point. `from` is the current
/// position of the material that the point had cut to, and `to` the point's new position.
struct Sweep {
  std::vector<Vec3> from, to;
  bool in_tissue = false;  // whether some point is in tissue, or was in the course of the tick
};

/// Returns the motion of a blade's edge points in the tick. A point advances only where tissue yields to it.
/// The area that the edges sweep is to be cut.
Sweep sweep_of(const Bodies& bodies, std::span<const organs::BladeGrip> grips, const organs::Blade& blade);

}  // namespace prosector
