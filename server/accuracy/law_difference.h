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

/// Returns how much less work tissue's law does than the body's own at the same load, J/m³ of the volume at
/// rest. Above 0: what is loaded gives way more in tissue than by the body's law. `tissue` has what of the
/// volume stays with the points, `mean` (Pa) is λ'' of what goes to the element's mean (mean_dilatation.h).
///
/// To first order the work of a load differs by the difference of stresses at the same strain, over that
/// strain. Nearly incompressible tissue would make that worthless: its pressure is what holds the load,
/// whatever the volume. So tissue takes the volume at which it has the body's mean pressure. What is compared
/// is the rest of stress, and what that volume lets the pressure do.
double law_difference(const ConstitutiveLaw& tissue, double mean, const ElementStrain& strain);

}  // namespace prosector
