#pragma once
// Tension that the rest shape is in balance with.

#include <memory>
#include <vector>

#include "common/anatomy/rest_stretch.h"
#include "common/scene/scene.h"

namespace prosector {

struct BalancedStretch {
  std::shared_ptr<const RestStretch> stretch;
  double moved = 0;  // m: how far what is left unbalanced would still move a node, by the last estimate
};

/// Returns tension (rest_stretch.h) that comes of `wanted`, V of each tetrahedron, when the rest shape is to
/// be an equilibrium of the body that `desc` describes, free and without weight. What the body would move by
/// is taken into V, as if it had moved so: what `wanted` shrinks is in balance with the rest. The anatomy has
/// no nodes on edges yet. Throws InputError as make_elastic_model() does.
BalancedStretch balanced_stretch(const SoftDesc& desc, Anatomy anatomy, std::vector<Mat3> wanted);

}  // namespace prosector
