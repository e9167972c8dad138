#pragma once
// Rotated elements: the data from which matrices of the corotational law are assembled. At an integration
// point of volume V let r_a = √(Vμ)·R·∇N_a. The warped stiffness (linear elastic stiffness rotated with the
// element, Müller & Gross 2004) has the blocks
//   K_ab = (λ/μ) r_a r_bᵀ + r_b r_aᵀ + (r_a·r_b) I = (λ/μ) r_a r_bᵀ + 2 (r_a·r_b) I − [r_a]ₓ[r_b]ₓᵀ
// and the tangent, see corotational_kernel.h,
//   H_ab = (λ/μ) r_a r_bᵀ + 2 (r_a·r_b) I + [r_a]ₓ T [r_b]ₓᵀ,   T = C/(2μ).
// The sum s·K + H, as used for Rayleigh damping, is (s + 1) times H with T = (C/(2μ) + I)/(s + 1) − I. An
// element's mean dilatation (mean_dilatation.h) adds m_a m_bᵀ, m_a = √(λ''/(4μ)) Σ_points r_a. Fibres of
// stiffness k along the unit vector c, rotated, add (f·r_a)(f·r_b) f fᵀ, f = (k/μ)^¼·c; slack ones f = 0.

#include <cstddef>
#include <vector>

namespace prosector::soft {

/// Vector of three floats x, y, z, padded to four so that one SIMD load reads it. Used for rotated gradients
/// r_a = √(Vμ)·R·∇N_a, in √(N/m).
struct alignas(16) CorotatedVector {
  float at[4];
};

/// Columns of the 3×3 matrix T of an integration point, which determines the rotational part of the
/// corotational tangent. The fourth float of the first column is λ/μ.
struct Twist {
  CorotatedVector column[3];
};

/// Rotated elements: rotated gradients and twist matrices T, from which the corotational tangent and the
/// warped stiffness are assembled. Entries are ordered by element, then integration point, then corner.
struct CorotatedElements {
  std::vector<CorotatedVector> gradient;
  std::vector<Twist> twist;            // by point
  std::vector<CorotatedVector> mean;   // by corner: m; empty: no element has a mean dilatation
  std::vector<CorotatedVector> fiber;  // by point: f; empty: there are no fibres
  /// Stiffness blocks by element, N/m, 9 floats for each pair of nodes, plus three readable floats; empty for
  /// the corotational law, whose blocks are summed row by row. With blocks, the arrays above serve damping
  /// only.
  std::vector<float> blocks;
};

}  // namespace prosector::soft
