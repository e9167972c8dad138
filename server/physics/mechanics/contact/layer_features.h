#pragma once
// Contacts between corners, edges and faces of parallel layers.
//
// Between parallel triangles all points are equally near, up to rounding. The nearest pair of points would
// therefore jump from tick to tick and lose its friction history. Contacts are planes: a plane oblique to the
// layers would also brake sliding. So for parallel layers each corner gets a contact with the other layer.
// Two edges get one if each lies in the other's normal cone. Both kinds have their normal across the layers.

#include <vector>

#include "server/physics/mechanics/contact/layers.h"

namespace prosector {

struct LayerElement {
  const ElementSurface& of;
  std::uint32_t index;
  const Triangle& now;
};

/// Returns whether the elements get feature contacts instead of a nearest-point contact: true for two
/// parallel triangles, and for a triangle and a rope segment.
bool meet_by_features(const LayerElement& a, const LayerElement& b);

/// Appends the feature contacts of two elements that don't intersect, up to `limit` (m) apart. Where one
/// surface meets itself, the corner's element is a.
void meet_features(const LayerElement& a, const LayerElement& b, double limit, double thickness,
                   std::vector<LayerMeeting>& out);

}  // namespace prosector
