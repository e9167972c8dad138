#pragma once
// Two solids that have got into each other deeper than the nearest face can tell the way out.
//
// A vertex that is deep inside is as near to the wrong side as to the right one: each would be led out its
// own way, which turns tissue inside out and draws both bodies together, and what is deeper than is looked
// for is held for ever. So such bodies are parted as wholes: everything of one that is inside the other is
// led along one direction, slowly and gently; in bodies less deep in each other only what has come through to
// another side. The direction is the one that makes their common volume less soonest, the
// integral of one surface's normals inside the other (Allard et al. 2010, "Volume contact constraints at
// arbitrary resolution"); or, where that is as good as zero because one is within the other, from middle to
// middle.

#include <span>
#include <vector>

#include "server/physics/contact/soft_meeting.h"

namespace prosector {

/// What of a solid is inside another, and how much.
struct Immersion {
  std::vector<VertexMeeting> vertices;  // inside; gap and place as find_meetings() tells, however deep
  double deepest = 0;                   // m
  Vec3 normals = Vec3::Zero();          // m²: sum of the surface's outward normals there, by area
  double area = 0;                      // m²: of the surface there
};

/// Surface vertices on tissue that is inside out tell nothing of where a body is: 1; empty: there are none.
using Unsure = std::span<const char>;

/// Lists which vertices of `from` are inside the solid `to`, however deep, but for those that are unsure or
/// nearest to what is; one mark a vertex of each.
Immersion find_immersion(const SoftSkin& from, const SoftSkin& to, Unsure of_from, Unsure of_to);

/// Whether what was found near the surfaces (`found`, gaps of `from` to `to`) asks for a look at all that is
/// inside: something is deeper than contacts leave it, or nothing is near though the first vertex is inside.
bool may_be_immersed(const SoftSkin& from, const SoftSkin& to, std::span<const VertexMeeting> found);

/// Unit, from b to a: the way in which two bodies part. `between_middles`: from b's middle to a's, m.
Vec3 way_apart(const Immersion& of_a, const Immersion& of_b, const Vec3& between_middles);

/// Whether the bodies are so deep in each other that all of both is led along one way.
bool is_whole_immersed(const Immersion& of_a, const Immersion& of_b, double cell);

/// Whether this vertex' nearest way out goes against that of the bodies, `along`: it has come through.
bool came_through(const VertexMeeting& inside, const Vec3& along, double cell);

}  // namespace prosector
