#pragma once
// Irradiance as spherical harmonics (Ramamoorthi and Hanrahan, An efficient representation for irradiance
// environment maps, SIGGRAPH 2001). Private to client/render.

#include <vector>

#include "common/math.h"

namespace prosector {

/// Light that arrives from a small solid angle around one direction.
struct LightPatch {
  Vec3 direction;      // unit
  double solid_angle;  // sr
  Vec3 radiance;
};

/// Returns the irradiance divided by π as a function of a surface's unit normal n. The nine RGB coefficients
/// belong to 1, x, y, z, xy, yz, zx, y² and x² − z² of n. The patches of incoming light must cover the whole
/// sphere. The truncation error is below 1 % for smooth light.
std::vector<Vec3> irradiance_of(const std::vector<LightPatch>& around);

}  // namespace prosector
