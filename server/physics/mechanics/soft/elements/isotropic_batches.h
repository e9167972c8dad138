#pragma once
// Element batches of the isotropic laws, and of such a law with fibres, with SIMD.

#include <memory>

#include "server/physics/mechanics/soft/elements/isotropic_kernel.h"
#include "server/physics/mechanics/soft/elements/law_batches.h"

namespace prosector::soft {

/// Creates SIMD-vectorised element batches of an isotropic law. `fibers`: whether the law adds the
/// fibres of the materials. `make` creates the same law, which evaluates
/// the double-precision stiffness element by element. `elements` must outlive the result.
std::unique_ptr<ElementBatches> make_isotropic_batches(
    IsotropicLaw law, bool fibers, std::unique_ptr<ConstitutiveLaw> (*make)(const Material&),
    const Materials& materials, const Tet4Elements& elements);

}  // namespace prosector::soft
