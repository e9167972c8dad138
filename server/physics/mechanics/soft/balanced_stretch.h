#pragma once
// Prestretch for which the rest shape is in equilibrium.

#include <memory>
#include <vector>

#include "common/anatomy/rest_stretch.h"
#include "common/scene/scene.h"

namespace prosector {

struct BalancedStretch {
  std::shared_ptr<const RestStretch> stretch;
  double moved = 0;  // m: largest node displacement by the remaining unbalanced forces, in the last estimate
};

/// Returns the prestretch (rest_stretch.h) closest to `wanted`, the stretch V of each tetrahedron, for which
/// the rest shape is in equilibrium. The body of `desc` is free and has no weight. The displacements by
/// unbalanced forces are added to V as if the body had moved: the parts that shrink are then balanced by the
/// rest. The anatomy must not have edge nodes yet. Throws InputError as make_elastic_model() does.
BalancedStretch balanced_stretch(const SoftDesc& desc, Anatomy anatomy, std::vector<Mat3> wanted);

}  // namespace prosector
