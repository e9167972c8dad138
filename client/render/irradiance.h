#pragma once
// Light from around as spherical harmonics (Ramamoorthi and Hanrahan, An efficient representation for
// irradiance environment maps, SIGGRAPH 2001). Private to client/render.

#include <vector>

#include "common/math.h"

namespace prosector {

/// Some of the light from around: where it comes from, from how much of the sphere, and how bright.
struct LightPatch {
  Vec3 direction;      // unit
  double solid_angle;  // sr
  Vec3 radiance;
};

/// Returns what lights a surface, over π, by its normal n: the sum of the nine times 1, x, y, z, xy, yz, zx,
/// y² and x² − z² of n. The patches take in the whole sphere. What is dropped is below 1 % of a smooth light.
std::vector<Vec3> irradiance_of(const std::vector<LightPatch>& around);

}  // namespace prosector
