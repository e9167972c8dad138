#pragma once
// The laws behind the rows of laws(); one file each.

#include "server/physics/soft/constitutive_law.h"

namespace prosector {

/// Small strain: W = μ‖ε‖² + λ/2 tr²ε, ε = sym(F) − I. Exact for small rotations only: turning the body
/// strains it.
std::unique_ptr<ConstitutiveLaw> make_fem_linear(const Lame& constants);

/// W = μ‖F − R‖² + λ/2 tr²(S − I) with F = RS (Müller & Gross 2004; the full derivative of McAdams et al.
/// 2011).
std::unique_ptr<ConstitutiveLaw> make_fem_corotational(const Lame& constants);

/// Pairs of principal stretches below this bend the corotational energy as if they were this far from
/// mirroring, where R turns over.
inline constexpr double least_corotational_pair = 1e-2;

/// Stable neo-Hookean with the logarithmic barrier against collapse (Smith, de Goes & Kim 2018, eq. 14).
std::unique_ptr<ConstitutiveLaw> make_fem_neo_hookean(const Lame& constants);

/// The same without the barrier (their eq. 11 with Λ = λ + μ): cheaper by a division, but a body squeezed
/// far below its size may stay collapsed.
std::unique_ptr<ConstitutiveLaw> make_fem_neo_hookean_polynomial(const Lame& constants);

}  // namespace prosector
