#pragma once
// Error of a constitutive law at one deformation: the work of its stress beyond that of tissue's law.

#include <span>

#include "server/physics/mechanics/soft/laws/constitutive_law.h"

namespace prosector {

/// Deformation of an element at its integration points, of which there are at most four.
struct ElementStrain {
  std::span<const Mat3> F;  // deformation gradients
  std::span<const Mat3> R;  // their rotations
  std::span<const Mat3> P;  // Pa: first Piola stress of the body's own law
};

/// Difference of two laws at one deformation.
struct LawDifference {
  Mat3 stress = Mat3::Zero();  // Pa: difference of RᵀP, mean over the points
  double pressure = 0;         // Pa: mean pressure, the same in both
  double stretch = 0;          // logarithm of the stretch beyond F at which tissue has that pressure
  double work = 0;             // J/m³ of the volume at rest: difference of work from no load on
};

/// Returns the difference between the stress of the body's own law and that of tissue's. `work` is the work
/// of the body's law beyond tissue's at the same strain. Above 0: under the same load tissue yields more than
/// the body's law does. `tissue` has the volumetric stiffness of the integration points, and `mean` (Pa) is
/// λ'', that of the element's mean (mean_dilatation.h).
///
/// To first order the work of a load differs by the difference of stresses at the same strain, over that
/// strain. For nearly incompressible tissue that would be useless: its pressure bears the load, almost
/// whatever the volume is. So tissue gets the volume at which it has the body's mean pressure. Then the rest
/// of the stress is compared, and the work of the pressure over that change of volume.
LawDifference law_difference(const ConstitutiveLaw& tissue, double mean, const ElementStrain& strain);

/// Returns the difference of work, J/m³, of loads added since `before`. It is for tissue under tension, whose
/// rest shape is the same with either law. `strain`: change of RᵀF since then.
double work_on_top(const LawDifference& now, const LawDifference& before, const Mat3& strain);

}  // namespace prosector
