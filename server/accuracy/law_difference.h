#pragma once
// What a law gets wrong at one deformation: the work that its stress leaves over, against tissue's.

#include <span>

#include "server/physics/soft/laws/constitutive_law.h"

namespace prosector {

/// How an element is deformed, at each of its integration points, of which there are at most four.
struct ElementStrain {
  std::span<const Mat3> F;  // deformation gradients
  std::span<const Mat3> R;  // their rotations
  std::span<const Mat3> P;  // Pa: first Piola stress of the body's own law
};

/// What two laws differ by at one deformation.
struct LawDifference {
  Mat3 stress = Mat3::Zero();  // Pa: of RᵀP, its mean over the points
  double pressure = 0;         // Pa: that both have
  double stretch = 0;          // logarithm of what tissue is stretched by beyond F for it
  double work = 0;             // J/m³ of the volume at rest, from no load on
};

/// Returns what of the body's own stress tissue's law would not have. `work` is how much less work tissue's
/// law does at the same load. Above 0: what is loaded gives way more in tissue than by the body's law.
/// `tissue` has what of the volume stays with the points, `mean` (Pa) is λ'' of what goes to the element's
/// mean (mean_dilatation.h).
///
/// To first order the work of a load differs by the difference of stresses at the same strain, over that
/// strain. Nearly incompressible tissue would make that worthless: its pressure is what holds the load,
/// whatever the volume. So tissue takes the volume at which it has the body's mean pressure. What is compared
/// is the rest of stress, and what that volume lets the pressure do.
LawDifference law_difference(const ConstitutiveLaw& tissue, double mean, const ElementStrain& strain);

/// Returns the work that it leaves over, J/m³, of what came on top of `before`: of tissue under tension,
/// which rests so by either law. `strain`: how RᵀF changed since then.
double work_on_top(const LawDifference& now, const LawDifference& before, const Mat3& strain);

}  // namespace prosector
