#pragma once
// Sheets and ropes, which have no inside, against each other and against themselves.

#include <utility>
#include <vector>

#include "server/physics/contact/element_surface.h"

namespace prosector {

/// What meets: of parallel layers a corner of the one and any of the other, or two edges (layer_features.h);
/// of others whatever is nearest.
enum class LayerMeet : std::uint8_t { corner_of_a, corner_of_b, edges, nearest };

/// Where elements of two surfaces, or of one, meet.
struct LayerMeeting {
  LayerMeet kind = LayerMeet::nearest;
  std::uint32_t a = 0, b = 0;                               // elements
  Vec3 weights_a = Vec3::Zero(), weights_b = Vec3::Zero();  // of their corners
  Vec3 normal = Vec3::UnitY();                              // unit, from b to a
  double gap = 0;                                           // m, less the thickness
};

/// Tells the meeting from b's side.
inline void swap_sides(LayerMeeting& m) {
  std::swap(m.a, m.b);
  std::swap(m.weights_a, m.weights_b);
  m.normal = -m.normal;
}

/// The side of b's element on which a's was when they were last apart: what has got through is sent back
/// there.
struct LayerSide {
  std::uint32_t a = 0, b = 0;
  Vec3 normal = Vec3::UnitY();  // unit, from b to a
};

/// How to look.
struct LayerSearch {
  double thickness = 0;  // m, at which they touch: half of either's
  double margin = 0;     // m: gaps up to it count
  /// Distance (m) below which elements at rest, that hang together by what is as near, are neighbours, no
  /// layers. 0: for two sheets.
  double apart_at_rest = 0;
  /// Distance (m) at rest of points that a cut parted and that lie beside each other, and don't meet. From
  /// there on they touch the farther apart the farther they were at rest, up to the thickness: so no cut
  /// makes an overlap.
  double seam = 0;
};

/// Finds speculative contacts: what is near gets one on the side where it is, before it can pass (cf.
/// Bridson, Fedkiw and Anderson 2002, "Robust treatment of collisions, contact and friction for cloth
/// animation"). What passed nevertheless is recognised by crossing elements, or by being on the other side
/// than `sides` say while nearer than the thickness, and is sent back. Replaces `sides` (ascending by
/// element) by those of this tick and appends the meetings, each pair of features once, in a fixed order.
/// Returns how many pairs of elements have passed. For a surface against itself, give it twice.
int find_layers(const ElementSurface& a, const ElementSurface& b, const LayerSearch& search,
                std::vector<LayerSide>& sides, std::vector<LayerMeeting>& out);

}  // namespace prosector
