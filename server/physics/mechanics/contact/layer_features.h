#pragma once
// Contacts between corners, edges and faces of parallel layers.
//
// Between parallel triangles all points are equally near, up to rounding. The nearest pair of points would
// therefore jump from tick to tick and lose its friction history. Contacts are planes: a plane oblique to the
// layers would also brake sliding. So for parallel layers each corner gets a contact with the other layer.
// Two edges get one if each lies in the other's normal cone. Both kinds have their normal across the layers.

#include <vector>

#include "server/physics/mechanics/contact/layers.h"

namespace prosector::contact {

struct LayerElement {
  const ElementSurface& of;
  std::uint32_t index;
  const collision::Triangle& now;
};

/// Returns whether contact of two elements of thin bodies is taken between their corners, edges and faces
/// instead of at their nearest points. This is true for two nearly parallel triangles, and for a triangle and
/// a rope segment.
bool meet_by_features(const LayerElement& a, const LayerElement& b);

/// Appends the contacts between corners, edges and faces of two elements of thin bodies that do not
/// intersect, up to `limit` (m) apart. `thickness`, m: distance at which the elements touch, subtracted from
/// the gaps. Where one surface meets itself, side a is the element with the corner.
void meet_features(const LayerElement& a, const LayerElement& b, double limit, double thickness,
                   std::vector<LayerMeeting>& out);

}  // namespace prosector::contact
