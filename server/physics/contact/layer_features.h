#pragma once
// Which corners, edges and faces of parallel layers bear each other.
//
// Between two triangles that are parallel all points are as near, or by rounding any. What is nearest of them
// leaps from tick to tick, and forgets what it holds by friction. And contacts are planes: where one lies
// aslant to the layers, it brakes what slides past. So there each corner meets the other layer, and edges
// meet where each is in the other's normal cone, both across the layers.

#include <vector>

#include "server/physics/contact/layers.h"

namespace prosector {

struct LayerElement {
  const ElementSurface& of;
  std::uint32_t index;
  const Triangle& now;
};

/// Tells whether their features are to meet, rather than what is nearest: so it is for triangles that are
/// parallel, and for a triangle and a rope's piece.
bool meet_by_features(const LayerElement& a, const LayerElement& b);

/// Appends where features of two elements that don't cross may bear each other, up to `limit` (m) apart.
/// Where one surface meets itself the corner's element is a.
void meet_features(const LayerElement& a, const LayerElement& b, double limit, double thickness,
                   std::vector<LayerMeeting>& out);

}  // namespace prosector
