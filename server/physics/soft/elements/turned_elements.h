#pragma once
// Elements as the corotational law's matrices see them, turned with the material. At an integration point of
// volume V let r_a = √(Vμ)·R·∇N_a. Hooke's stiffness turned with the element (warped stiffness, Müller &
// Gross 2004) has the blocks
//   K_ab = (λ/μ) r_a r_bᵀ + r_b r_aᵀ + (r_a·r_b) I = (λ/μ) r_a r_bᵀ + 2 (r_a·r_b) I − [r_a]ₓ[r_b]ₓᵀ
// and the tangent, see corotational_kernel.h,
//   H_ab = (λ/μ) r_a r_bᵀ + 2 (r_a·r_b) I + [r_a]ₓ T [r_b]ₓᵀ,   T = C/(2μ).
// The sum s·K + H, as Rayleigh damping adds it, is (s + 1) times the same with T = (C/(2μ) + I)/(s + 1) − I.
// An element's mean dilatation (mean_dilatation.h) adds m_a m_bᵀ, m_a = √(λ''/(4μ)) Σ_points r_a.

#include <cstddef>
#include <vector>

namespace prosector {

/// x, y, z and room, in √(N/m) where it is a gradient; one load brings it.
struct alignas(16) TurnedVector {
  float at[4];
};

/// T's columns; the first one's fourth float is λ/μ.
struct Twist {
  TurnedVector column[3];
};

/// By element, then point, then corner.
struct TurnedElements {
  std::vector<TurnedVector> gradient;
  std::vector<Twist> twist;        // of each point
  std::vector<TurnedVector> mean;  // m of each corner; empty: no element has one
};

}  // namespace prosector
