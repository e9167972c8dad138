#pragma once
// Contact of sheets and ropes, which have no inside, with each other and with themselves.

#include <utility>
#include <vector>

#include "server/physics/mechanics/contact/element_surface.h"

namespace prosector {

/// Kind of a layer contact. For parallel layers: a corner of one element against any point of the other, or
/// two edges (layer_features.h). Otherwise: the nearest points.
enum class LayerMeet : std::uint8_t { corner_of_a, corner_of_b, edges, nearest };

/// A contact point between elements of two surfaces, or of one surface.
struct LayerMeeting {
  LayerMeet kind = LayerMeet::nearest;
  std::uint32_t a = 0, b = 0;                               // element indices
  Vec3 weights_a = Vec3::Zero(), weights_b = Vec3::Zero();  // barycentric, of their corners
  Vec3 normal = Vec3::UnitY();                              // unit, from b to a
  double gap = 0;                                           // m, minus the thickness
};

/// Swaps sides a and b of the meeting.
inline void swap_sides(LayerMeeting& m) {
  std::swap(m.a, m.b);
  std::swap(m.weights_a, m.weights_b);
  m.normal = -m.normal;
}

/// The side of b's element on which a's element was when they were last apart. Elements that passed through
/// are sent back to this side.
struct LayerSide {
  std::uint32_t a = 0, b = 0;
  Vec3 normal = Vec3::UnitY();  // unit, from b to a
};

/// Parameters of the layer search.
struct LayerSearch {
  double thickness = 0;  // m: distance at which the layers touch, the sum of both half thicknesses
  double margin = 0;     // m: larger gaps are ignored
  /// Distance (m) at rest below which elements, connected by elements that are as near, count as neighbours,
  /// not as layers. 0: for two different sheets.
  double apart_at_rest = 0;
  /// Distance (m) at rest of points on both sides of a cut, which do not touch there. From this distance on,
  /// the contact distance grows with the distance at rest, up to the thickness. So a cut creates no overlap.
  double seam = 0;
};

/// Finds speculative contacts: near elements get a contact on their current side before they can pass (cf.
/// Bridson, Fedkiw and Anderson 2002, "Robust treatment of collisions, contact and friction for cloth
/// animation"). Elements that passed nevertheless are sent back. They are recognised by intersection, or by
/// being nearer than the thickness on the other side than in `sides`. Replaces `sides` (ascending by element)
/// by those of this tick. Appends the meetings, each pair of features once, in a fixed order. Returns the
/// number of element pairs that have passed. For self-contact, pass the same surface twice.
int find_layers(const ElementSurface& a, const ElementSurface& b, const LayerSearch& search,
                std::vector<LayerSide>& sides, std::vector<LayerMeeting>& out);

}  // namespace prosector
