#pragma once

namespace prosector::contact {

/// Returns the stiffness (N/m) of contacts between rigid bodies of an island (bodies solved together) for a
/// tick of h s. `heaviest`: mass of the island's heaviest body, kg. The stiffness is so large that this body
/// may rest on a light one and sink in no deeper than 0.2 mm.
inline double rigid_contact_stiffness(double heaviest, double h) {
  constexpr double rigid_contact_factor = 20;
  return rigid_contact_factor * heaviest / (h * h);
}

}  // namespace prosector::contact
