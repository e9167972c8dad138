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

namespace prosector {

/// The part of a solid's surface that is inside another solid.
struct Immersion {
  std::vector<VertexMeeting> vertices;  // inside; gap and point as of find_meetings(), at any depth
  double deepest = 0;                   // m
  Vec3 normals = Vec3::Zero();          // m²: area-weighted sum of the surface's outward normals there
  double area = 0;                      // m²: area of the surface there
};

/// Two solids that have overlapped for a while. Once begun, they are led until they are apart, because a
/// vertex that is half out seems to have entered from another side.
struct Entanglement {
  Vec3 way = Vec3::Zero();  // unit, from the second body to the first
  bool whole = false;       // whether all vertices inside are led, not only those that came through
  double seconds = 0;
};

/// Marks of surface vertices, 1: embedded in inverted tissue, whose position is unreliable. Empty: no marks.
using Unsure = std::span<const char>;

/// Lists the vertices of `from` inside the solid `to`, at any depth. Leaves out unsure vertices and vertices
/// nearest to an unsure face. One mark per vertex of each body.
Immersion find_immersion(const SoftSkin& from, const SoftSkin& to, Unsure of_from, Unsure of_to);

/// Returns whether a vertex of one body is deeper in the other than contacts leave it. `cell`: m, the smaller
/// of both cells.
bool is_deep(const Immersion& of_a, const Immersion& of_b, double cell);

/// Returns whether find_immersion() is needed, given the contacts near the surfaces (`found`, of `from` with
/// `to`). It is needed where a contact is deeper than contacts leave it. It is needed too where no contact
/// was found but the first vertex is inside.
bool may_be_immersed(const SoftSkin& from, const SoftSkin& to, std::span<const VertexMeeting> found);

/// Returns the direction (unit, from b to a) in which two bodies are separated. `between_middles`: from b's
/// centre to a's, m.
Vec3 way_apart(const Immersion& of_a, const Immersion& of_b, const Vec3& between_middles);

/// Returns whether the vertex is deep and its nearest way out opposes the separation direction `along`.
bool came_through(const VertexMeeting& inside, const Vec3& along, double cell);

/// Returns how the bodies are led apart in this tick of h s, given their previous entanglement `before`.
/// Returns none where contacts suffice to separate them. `cell`: m, the smaller of both cells. All vertices
/// inside are led
///   where one is deeper than contact search reaches,
///   where a vertex that came through has not soon returned,
///   and where the bodies stay deep although nobody presses them (`pressed`).
std::optional<Entanglement> lead_apart(const Immersion& of_a, const Immersion& of_b,
                                       const Vec3& between_middles, const Entanglement* before, bool pressed,
                                       double cell, double h);

}  // namespace prosector
