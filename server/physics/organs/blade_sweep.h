#pragma once
// Where a blade's edges get to in a tick, with tissue that holds them back.

#include <span>
#include <vector>

#include "server/physics/bodies.h"
#include "server/physics/organs/blade_grip.h"

namespace prosector {

/// m, world frame: per point of the blade's edges, where its material is now and where the point gets to.
struct Sweep {
  std::vector<Vec3> from, to;
  bool in_tissue = false;  // some point is, or was on its way
};

/// Returns where tissue lets go of the blade's points, which has moved on: what they sweep through is to be
/// cut.
Sweep sweep_of(const Bodies& bodies, std::span<const BladeGrip> grips, const Blade& blade);

}  // namespace prosector
