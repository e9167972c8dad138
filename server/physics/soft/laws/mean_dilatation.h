#pragma once
// The remedy for volumetric locking. Where material is nearly incompressible, an element feels most of its
// change of volume as its mean over the element. That is one constraint instead of one at every integration
// point (Nagtegaal, Parks & Rice 1974; as a split of the energy: Simo, Taylor & Pister 1985).
//
// A law's volumetric part is λ/2·θ², θ its own measure of dilatation (ConstitutiveLaw::dilatation). With λ =
// λ' + λ'' an element stores
//   Σ_q V_q W(F_q; λ') + λ''/2·V·θ̄²,   θ̄ = Σ_q V_q θ(F_q)/V,
// which is the law itself wherever θ is constant over the element. Its tangent is that of W + p·θ at each
// point, with the pressure p = λ''θ̄, and λ''/V·G·Gᵀ with G = Σ_q V_q ∂θ/∂x.

#include <vector>

#include "server/physics/soft/laws/material.h"

namespace prosector {

/// Poisson's ratio whose λ' stays with the points, so that no deformation within an element is free; what a
/// material has above goes to the mean. Chosen by the reference beam on 192 elements, whose deflection at
/// ν = 0.499 is off by −5.1, −3.4, −1.6, −0.4 and +1.1 % for 0.45, 0.4, 0.3, 0.2 and 0.
inline constexpr double most_local_poisson_ratio = 0.2;

struct SplitMaterials {
  Materials local;           // with λ'
  std::vector<double> mean;  // λ'' of each kind, Pa; empty: none has any
};
SplitMaterials split_volume(const Materials& materials);

}  // namespace prosector
