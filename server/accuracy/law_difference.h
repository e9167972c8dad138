#pragma once
// Error of a constitutive law at one deformation: the work of its stress beyond that of tissue's law.

#include <span>

#include "server/physics/mechanics/soft/laws/constitutive_law.h"

namespace prosector {

/// Deformation of an element and its stress at the element's integration points, of which there are at most
/// four.
struct ElementStrain {
  std::span<const Mat3> F;  // deformation gradients
  std::span<const Mat3> R;  // their rotations
  std::span<const Mat3> P;  // Pa: first Piola stress of the body's own law
};

/// Difference between a body's constitutive law and tissue's law at one deformation: of stress, and of work.
struct LawDifference {
  Mat3 stress = Mat3::Zero();  // Pa: difference of RᵀP, mean over the points
  double pressure = 0;         // Pa: mean pressure, the same in both
  double stretch = 0;          // logarithm of the stretch beyond F at which tissue has that pressure
  double work = 0;             // J/m³ of the volume at rest: difference of work from no load on
};

/// Returns the difference between the stress of the body's own law and that of tissue's law. `work` is the
/// work of the body's law in excess of tissue's at the same strain. If it is above 0, tissue yields more
/// under the same load than the body's law does. `tissue` has the volumetric stiffness of the integration
/// points. `mean` (Pa) is λ'', the volumetric stiffness of the element's mean dilatation (mean_dilatation.h).
///
/// To first order the work of a load differs by the difference of stresses at the same strain, times that
/// strain. For nearly incompressible tissue this would be useless: its pressure bears the load, almost
/// whatever the volume is. So tissue gets the volume at which it has the body's mean pressure. Then the rest
/// of the stress is compared, and the work of the pressure over that change of volume.
LawDifference law_difference(const soft::ConstitutiveLaw& tissue, double mean, const ElementStrain& strain);

/// Returns the difference between the works (J/m³) of two laws for the loads added since the state `before`.
/// It is for tissue under tension, whose rest shape is the same with either law. `strain` is the change of
/// RᵀF since `before`, with F the deformation gradient and R its rotation.
double work_on_top(const LawDifference& now, const LawDifference& before, const Mat3& strain);

}  // namespace prosector
