#pragma once
// Motion of a blade's edges in a tick, with the resistance of tissue.

#include <span>
#include <vector>

#include "server/physics/stations/dissecting/blade_grip.h"
#include "server/physics/world/bodies.h"

namespace prosector {

/// m, world frame, by point of the blade's edges: current position of its material, and the point's new
/// position.
struct Sweep {
  std::vector<Vec3> from, to;
  bool in_tissue = false;  // whether some point is in tissue, or was in the course of the tick
};

/// Returns the motion of the blade's points after the tick, where tissue yields to them. The swept area is to
/// be cut.
Sweep sweep_of(const Bodies& bodies, std::span<const BladeGrip> grips, const Blade& blade);

}  // namespace prosector
