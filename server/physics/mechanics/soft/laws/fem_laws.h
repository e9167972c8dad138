#pragma once
// Factories of the laws in laws(); one file each.

#include "server/physics/mechanics/soft/laws/constitutive_law.h"

namespace prosector::soft {

/// Returns the external pressure (Pa) on element e: pressure[e], or 0 if `pressure` is empty.
inline double pressure_at(std::span<const double> pressure, std::size_t e) {
  return pressure.empty() ? 0 : pressure[e];
}

/// Creates the law of linear elasticity: W = μ‖ε‖² + λ/2 tr²ε with the strain ε = sym(F) − I. Valid for small
/// rotations only: rotating the body strains it.
std::unique_ptr<ConstitutiveLaw> make_fem_linear(const Material& constants);

/// Creates the corotational law: W = μ‖F − R‖² + λ/2 tr²(S − I), where F = RS is the polar decomposition
/// (Müller & Gross 2004). Its derivatives include those of R (McAdams et al. 2011).
std::unique_ptr<ConstitutiveLaw> make_fem_corotational(const Material& constants);

/// Lower bound of a sum of two principal stretches in the tangent of the corotational law, which divides by
/// such sums. Smaller sums count as this value. They occur near mirrored states, at which the rotation R
/// jumps.
inline constexpr double least_corotational_pair = 1e-2;

/// Creates the St. Venant–Kirchhoff law: W = μ‖E‖² + λ/2 tr²E with Green's strain E = (FᵀF − I)/2. The law is
/// objective, but a mirrored element has no more energy than an intact one. Below a stretch of 1/√3 it
/// softens instead of resisting. Use it for moderate strain and for comparison with textbooks.
std::unique_ptr<ConstitutiveLaw> make_fem_stvk(const Material& constants);

/// Creates the stable neo-Hookean law with the logarithmic barrier against collapse of an element (Smith, de
/// Goes & Kim 2018, "Stable neo-Hookean flesh simulation", eq. 14).
std::unique_ptr<ConstitutiveLaw> make_fem_neo_hookean(const Material& constants);

/// Creates the stable neo-Hookean law without the logarithmic barrier (Smith, de Goes & Kim 2018, eq. 11 with
/// Λ = λ + μ). It saves a division, but a body compressed far below its size may stay collapsed.
std::unique_ptr<ConstitutiveLaw> make_fem_neo_hookean_polynomial(const Material& constants);

/// Creates the law of make_fem_neo_hookean with fibres along the unit vector a = constants.fiber. Under
/// tension they add the energy density k/8·⟨|Fa|² − 1⟩², where k = constants.fiber_stiffness (Pa) and ⟨·⟩ is
/// the positive part; slack fibres add nothing. This is the quadratic member of the family of Holzapfel,
/// Gasser & Ogden 2000. At small strain it raises the stiffness along a by k.
std::unique_ptr<ConstitutiveLaw> make_fem_fibers(const Material& constants);

/// Creates a law that resists changes of volume only: W = λ/2·(J − 1)², where J is the ratio of current to
/// rest volume. Model `mass_spring` uses it to preserve volume.
std::unique_ptr<ConstitutiveLaw> make_volume_law(const Material& constants);

}  // namespace prosector::soft
