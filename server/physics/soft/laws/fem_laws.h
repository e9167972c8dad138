#pragma once
// The laws behind the rows of laws(); one file each.

#include "server/physics/soft/laws/constitutive_law.h"

namespace prosector {

/// Returns the pressure at element e; 0 where there are none.
inline double pressure_at(std::span<const double> pressure, std::size_t e) {
  return pressure.empty() ? 0 : pressure[e];
}

/// Makes the law of small strain: W = μ‖ε‖² + λ/2 tr²ε, ε = sym(F) − I. It is exact for small rotations only:
/// turning the body strains it.
std::unique_ptr<ConstitutiveLaw> make_fem_linear(const Material& constants);

/// Makes the corotational law: W = μ‖F − R‖² + λ/2 tr²(S − I) with F = RS (Müller & Gross 2004; the full
/// derivative of McAdams et al. 2011).
std::unique_ptr<ConstitutiveLaw> make_fem_corotational(const Material& constants);

/// Pairs of principal stretches below this bend the corotational energy as if they were this far from
/// mirroring, where R turns over.
inline constexpr double least_corotational_pair = 1e-2;

/// Makes St. Venant–Kirchhoff's law: W = μ‖E‖² + λ/2 tr²E with Green's strain E = (FᵀF − I)/2. It turns
/// freely, but a mirrored element is as content as a whole one. Below a stretch of 1/√3 it yields instead of
/// resisting. It is for moderate strain and for comparison with textbooks.
std::unique_ptr<ConstitutiveLaw> make_fem_stvk(const Material& constants);

/// Makes the stable neo-Hookean law with the logarithmic barrier against collapse (Smith, de Goes & Kim 2018,
/// eq. 14).
std::unique_ptr<ConstitutiveLaw> make_fem_neo_hookean(const Material& constants);

/// Makes the stable neo-Hookean law without the barrier (their eq. 11 with Λ = λ + μ): cheaper by a division,
/// but a body squeezed far below its size may stay collapsed.
std::unique_ptr<ConstitutiveLaw> make_fem_neo_hookean_polynomial(const Material& constants);

/// Makes make_fem_neo_hookean's tissue with fibres along a = constants.fiber. In tension they add k/8 ⟨|Fa|²
/// − 1⟩², k = constants.fiber_stiffness; slack they add nothing. (The quadratic member of the family of
/// Holzapfel, Gasser & Ogden 2000.) At small strain they raise the stiffness along a by k.
std::unique_ptr<ConstitutiveLaw> make_fem_fibers(const Material& constants);

/// Resists changes of volume only: W = λ/2 (J − 1)². What `mass_spring` adds to hold volume.
std::unique_ptr<ConstitutiveLaw> make_volume_law(const Material& constants);

}  // namespace prosector
