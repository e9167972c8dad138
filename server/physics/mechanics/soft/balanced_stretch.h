#pragma once
// Prestretch for which the rest shape is in equilibrium.

#include <memory>
#include <vector>

#include "common/anatomy/rest_stretch.h"
#include "common/scene/scene.h"

namespace prosector::soft {

struct BalancedStretch {
  std::shared_ptr<const RestStretch> stretch;
  double moved = 0;  // m: largest node displacement by the remaining unbalanced forces, in the last estimate
};

/// Returns the prestretch closest to `wanted` for which the body's rest shape is in equilibrium. A prestretch
/// gives for each tetrahedron the stretch V from its stress-free shape to the rest shape; `wanted` has the
/// desired V of each. The body is treated as free and weightless. Each iteration adds the displacement
/// gradients due to the unbalanced forces to V, as if the body had moved to its equilibrium. `anatomy` must
/// not have the edge nodes of quadratic elements yet. Throws InputError for constants out of range.
BalancedStretch balanced_stretch(const SoftDesc& desc, Anatomy anatomy, std::vector<Mat3> wanted);

}  // namespace prosector::soft
