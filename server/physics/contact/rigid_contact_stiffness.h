#pragma once

namespace prosector {

/// Returns the stiffness of contacts between rigid bodies in an island whose heaviest body has that mass, for
/// a tick of h s, N/m: that body may rest on a light one, no deeper than 0.2 mm.
inline double rigid_contact_stiffness(double heaviest, double h) {
  constexpr double rigid_contact_factor = 20;
  return rigid_contact_factor * heaviest / (h * h);
}

}  // namespace prosector
