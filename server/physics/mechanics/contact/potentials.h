#pragma once
// Scalar potentials of contacts, friction and bounded springs, with derivatives.

#include <algorithm>
#include <cmath>

namespace prosector::contact {

/// Potential of a spring whose force never exceeds a bound F (Huber function of the displacement d): ½kd² up
/// to d = F/k, then linear with slope F.
struct BoundedSpring {
  double stiffness, max_force;
  double energy(double d) const {
    const double knee = max_force / stiffness;
    return d <= knee ? stiffness * d * d / 2 : max_force * (d - knee / 2);
  }
  /// Returns φ′(d)/d, N/m, the derivative of the energy φ over the displacement d (m). Multiplied with the
  /// displacement vector it gives the force. It is an upper bound of the second derivative.
  double secant(double d) const { return d * stiffness <= max_force ? stiffness : max_force / d; }
};

/// Smoothed Coulomb friction (Li et al. 2020, eq. 15), per unit of maximum friction force. The slope of the
/// energy over the slip rises from 0 to 1 while the slip rises from 0 to `threshold`.
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

/// Contact potential ½k·min(g, 0)² of a gap g, averaged over an area on which g varies linearly by ± spread
/// about its mean. So contact forces start and end without a jump. With spread 0 it is a one-sided spring.
struct EvenSpring {
  double k;       // N/m
  double spread;  // m
  double energy(double g) const {
    if (g >= spread) return 0;
    if (g <= -spread) return k * g * g / 2 + k * spread * spread / 6;
    const double d = spread - g;
    return k * d * d * d / (12 * spread);
  }
  /// Returns the derivative, N, of the energy with respect to the gap g (m). It is never positive; its
  /// negative is the contact force.
  double slope(double g) const {
    if (g >= spread) return 0;
    return g <= -spread ? k * g : -k * (spread - g) * (spread - g) / (4 * spread);
  }
  /// Returns the second derivative, N/m, of the energy with respect to the gap g (m): k times the fraction of
  /// the area on which the gap is negative.
  double stiffness(double g) const {
    if (g >= spread) return 0;
    return g <= -spread ? k : k * (spread - g) / (2 * spread);
  }
};

}  // namespace prosector::contact
