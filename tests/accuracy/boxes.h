#pragma once
// Boxes of tissue for tests of accuracy.

#include "common/anatomy/kuhn_box.h"
#include "common/mesh.h"
#include "common/scene/scene.h"

namespace prosector::test {

inline const Vec3 gravity(0, -9.81, 0);

/// Makes a box whose lowest corner is the room's origin.
inline Anatomy box(const Vec3& size, std::uint32_t nx, std::uint32_t ny, std::uint32_t nz) {
  return {kuhn_box(size, nx, ny, nz), {}, {}};
}

/// Describes tissue that is pinned where x, y or z (axis 0, 1, 2) is 0.
inline SoftDesc pinned(int axis, double youngs_modulus, double poisson_ratio) {
  constexpr double far = 1e4;
  SoftDesc desc;
  desc.name = "box";
  desc.configuration.model = "fem_neo_hookean";
  desc.material.youngs_modulus = youngs_modulus;
  desc.material.poisson_ratio = poisson_ratio;
  desc.material.density = 1000;
  desc.attach.push_back({-far * Vec3::Unit(axis), far + 1e-6, 1e13});
  return desc;
}

}  // namespace prosector::test
