#pragma once
// Sheets and ropes, which have no inside, against each other and against themselves.

#include <vector>

#include "server/physics/contact/element_surface.h"

namespace prosector {

/// Where elements of two surfaces, or of one, meet: a corner and a face, or two edges.
struct LayerMeeting {
  std::uint32_t a = 0, b = 0;                               // elements
  Vec3 weights_a = Vec3::Zero(), weights_b = Vec3::Zero();  // of their corners
  Vec3 normal = Vec3::UnitY();                              // unit, from b to a
  double gap = 0;                                           // m, less the thickness
};

/// On which side of b's element a's was when they were last apart: what has got through is sent back there.
struct LayerSide {
  std::uint32_t a = 0, b = 0;
  Vec3 normal = Vec3::UnitY();  // unit, from b to a
};

/// How to look.
struct LayerSearch {
  double thickness = 0;      // m, at which they touch: half of either's
  double margin = 0;         // m: gaps up to it count
  double apart_at_rest = 0;  // m: parts nearer than that at rest are neighbours, no layers; 0: of two sheets
};

/// Speculative contacts: what is near gets one on the side where it is, before it can pass (cf. Bridson,
/// Fedkiw and Anderson 2002, "Robust treatment of collisions, contact and friction for cloth animation").
/// What passed nevertheless is recognised by crossing elements, or by being on the other side than `sides`
/// say while nearer than the thickness, and is sent back.
/// Replaces `sides` (ascending by element) by those of this tick and appends the meetings, each pair of
/// features once, in a fixed order. Returns how many pairs of elements have passed. For a surface against
/// itself, give it twice.
int find_layers(const ElementSurface& a, const ElementSurface& b, const LayerSearch& search,
                std::vector<LayerSide>& sides, std::vector<LayerMeeting>& out);

}  // namespace prosector
