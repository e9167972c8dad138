#pragma once
// Scalar potentials of contacts, friction and bounded springs, with derivatives.

#include <algorithm>
#include <cmath>

namespace prosector {

/// φ(d) = ½kd² for d ≤ F/k, then linear with slope F (Huber): a spring whose force never exceeds F.
struct BoundedSpring {
  double stiffness, max_force;
  double energy(double d) const {
    const double knee = max_force / stiffness;
    return d <= knee ? stiffness * d * d / 2 : max_force * (d - knee / 2);
  }
  /// Returns φ′(d)/d. Times the vector it is the force; it is a majorant of the second derivative.
  double secant(double d) const { return d * stiffness <= max_force ? stiffness : max_force / d; }
};

/// Smoothed Coulomb friction (Li et al. 2020, eq. 15): the energy's slope rises to 1 over the slip
/// `threshold`.
struct FrictionNorm {
  double threshold;  // m
  double energy(double slip) const {
    if (slip >= threshold) return slip;
    const double r = slip / threshold;
    return threshold * (r * r * (1 - r / 3) + 1.0 / 3);
  }
  double secant(double slip) const {
    return slip >= threshold ? 1 / slip : (2 - slip / threshold) / threshold;
  }
};

}  // namespace prosector
