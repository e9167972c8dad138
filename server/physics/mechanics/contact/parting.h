#pragma once
// Separation of two solids that overlap deeper than the nearest face can resolve.
//
// A vertex deep inside is as near to the wrong side as to the right one. If each vertex took its own shortest
// way out, tissue would invert and the bodies would attract each other. Vertices deeper than the search depth
// would never be released. So such bodies are separated as wholes. All vertices of one body inside the other
// are led along one direction, slowly and with small forces. At less depth, only the vertices that came
// through to another side are led.
//
// The direction is the one that reduces the common volume fastest. It is the integral of one surface's
// normals inside the other (Allard et al. 2010, "Volume contact constraints at arbitrary resolution"). Where
// that integral is nearly zero because one body is within the other, the direction joins the centres.

#include <optional>
#include <span>
#include <vector>

#include "server/physics/mechanics/contact/soft_meeting.h"

namespace prosector::contact {

/// Part of a solid's surface that is inside another solid: the vertices, the largest depth, and the area with
/// its mean direction.
struct Immersion {
  std::vector<VertexMeeting> vertices;  // inside; gap and point as of find_meetings(), at any depth
  double deepest = 0;                   // m
  Vec3 normals = Vec3::Zero();          // m²: area-weighted sum of the surface's outward normals there
  double area = 0;                      // m²: area of the surface there
};

/// State of the separation of two solids that have overlapped for a while. It continues until they are apart,
/// because a vertex that is half out seems to have entered from another side.
struct Entanglement {
  Vec3 way = Vec3::Zero();  // unit, from the second body to the first
  bool whole = false;       // whether all vertices inside are led, not only those that came through
  double seconds = 0;
};

/// One mark per surface vertex: 1 if the vertex is embedded in inverted tissue, so that its position is
/// unreliable. Empty if no vertex is marked.
using Unsure = std::span<const char>;

/// Lists the surface vertices of solid `from` that are inside solid `to`, at any depth. Leaves out vertices
/// marked in `of_from` as unreliable (see Unsure), and vertices whose nearest face of `to` has a corner
/// marked in `of_to`.
Immersion find_immersion(const SoftSkin& from, const SoftSkin& to, Unsure of_from, Unsure of_to);

/// Returns whether a vertex of solid a in b, or of b in a, is deeper than ordinary contacts leave it: by a
/// quarter of `cell`. `cell`: m, the smaller of both surfaces' mean edge lengths.
bool is_deep(const Immersion& of_a, const Immersion& of_b, double cell);

/// Returns whether `from` may be so deep inside `to` that find_immersion() is needed. `found`: the contacts
/// of vertices of `from` with `to`. It is needed if a contact is deeper than a quarter of an edge length, or
/// if there is no contact but the first vertex of `from` is inside `to`. Returns false unless both are
/// solids.
bool may_be_immersed(const SoftSkin& from, const SoftSkin& to, std::span<const VertexMeeting> found);

/// Returns the unit direction, from b to a, in which two overlapping solids a and b are separated.
/// `between_middles`: vector from b's centre to a's, m, used where the surfaces inside define no direction.
Vec3 way_apart(const Immersion& of_a, const Immersion& of_b, const Vec3& between_middles);

/// Returns whether a vertex inside the other solid is deep (by more than a quarter of `cell`, m) and its
/// shortest way out opposes the separation direction `along`. Such a vertex came through to another side of
/// the solid.
bool came_through(const VertexMeeting& inside, const Vec3& along, double cell);

/// Returns how two overlapping solids are to be separated in this tick of h s. Returns none where ordinary
/// contacts suffice. `before`: their state of separation in the last tick, or null. `pressed`: whether other
/// bodies press them together. `cell`: m, the smaller of both surfaces' mean edge lengths.
///
/// All vertices inside are moved out if one of them is deeper than contact search reaches. They are also
/// moved if a vertex that came through to another side has not returned within 0.25 s, or if unpressed solids
/// stay deep for 0.5 s. Otherwise only vertices that came through are moved.
std::optional<Entanglement> lead_apart(const Immersion& of_a, const Immersion& of_b,
                                       const Vec3& between_middles, const Entanglement* before, bool pressed,
                                       double cell, double h);

}  // namespace prosector::contact
