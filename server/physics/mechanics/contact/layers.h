#pragma once
// Contact of sheets and ropes, which have no inside, with each other and with themselves.

#include <utility>
#include <vector>

#include "server/physics/mechanics/contact/element_surface.h"

namespace prosector::contact {

/// Kind of a contact between elements of sheets or ropes. For parallel elements it is a corner of one element
/// against any point of the other, or two edges (layer_features.h). Otherwise it is between the nearest
/// points.
enum class LayerMeet : std::uint8_t { corner_of_a, corner_of_b, edges, nearest };

/// Contact point between two elements of sheets or ropes, which belong to two surfaces a and b or to the same
/// one.
struct LayerMeeting {
  LayerMeet kind = LayerMeet::nearest;
  std::uint32_t a = 0, b = 0;                               // element indices
  Vec3 weights_a = Vec3::Zero(), weights_b = Vec3::Zero();  // barycentric, of their corners
  Vec3 normal = Vec3::UnitY();                              // unit, from b to a
  double gap = 0;                                           // m, minus the thickness
};

/// Swaps sides a and b of a contact between two elements, and reverses its normal. The kind is not changed.
inline void swap_sides(LayerMeeting& m) {
  std::swap(m.a, m.b);
  std::swap(m.weights_a, m.weights_b);
  m.normal = -m.normal;
}

/// Stored side of b's element on which a's element was when they were last apart. Elements that passed
/// through each other are pushed back to this side.
struct LayerSide {
  std::uint32_t a = 0, b = 0;
  Vec3 normal = Vec3::UnitY();  // unit, from b to a
};

/// Parameters of the search for contacts of sheets and ropes: thickness, margin, and which elements of one
/// body count as neighbours.
struct LayerSearch {
  double thickness = 0;  // m: distance at which the layers touch, the sum of both half thicknesses
  double margin = 0;     // m: larger gaps are ignored
  /// Distance (m) at rest below which two elements of a body count as neighbours, which make no contact. They
  /// must also be connected by a chain of elements that are as close. 0 for contact of two different bodies.
  double apart_at_rest = 0;
  /// Distance (m) at rest between points on both sides of a cut; points at this distance do not touch. From
  /// it on, the contact distance grows with the distance at rest, up to `thickness`. So the sides of a cut do
  /// not overlap initially.
  double seam = 0;
};

/// Finds contacts between the elements of two thin bodies, or of one with itself (pass the same surface
/// twice). Close elements get a contact on their current side before they can pass through each other (cf.
/// Bridson, Fedkiw and Anderson 2002, "Robust treatment of collisions, contact and friction for cloth
/// animation"). Elements that passed nevertheless are pushed back. They are recognised by intersection, or by
/// being closer than the thickness on the other side than in `sides`.
///
/// Replaces `sides` (ascending by element) by the sides of this tick. Appends the contacts to `out`, each
/// pair of features once, in a fixed order. Returns the number of element pairs that have passed through each
/// other.
int find_layers(const ElementSurface& a, const ElementSurface& b, const LayerSearch& search,
                std::vector<LayerSide>& sides, std::vector<LayerMeeting>& out);

}  // namespace prosector::contact
