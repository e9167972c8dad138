#pragma once
// Two solids that have got into each other deeper than the nearest face can tell the way out.
//
// A vertex that is deep inside is as near to the wrong side as to the right one. Each would be led out its
// own way, which turns tissue inside out and draws both bodies together. And what is deeper than is looked
// for is held for ever. So such bodies are parted as wholes. Everything of one that is inside the other is
// led along one direction, slowly and gently; so is what is through the other. In bodies less deep in each
// other only the little that has come through to another side is led. The direction is the one that makes
// their common volume less soonest. It is the integral of one surface's normals inside the other (Allard et
// al. 2010, "Volume contact constraints at arbitrary resolution"). Where that is as good as zero because one
// is within the other, it is from middle to middle.

#include <optional>
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

/// Two solids that have been in each other for a while. They are led on as they were begun to be, until they
/// are apart: what is half out looks as if it had come from elsewhere.
struct Entanglement {
  Vec3 way = Vec3::Zero();  // unit, from the second to the first
  bool whole = false;       // all that is inside is led, not only what came through
  double seconds = 0;
};

/// Marks of surface vertices, 1: on tissue that is inside out, which tells nothing of where a body is. Empty:
/// there are none.
using Unsure = std::span<const char>;

/// Lists which vertices of `from` are inside the solid `to`, however deep, but for those that are unsure or
/// nearest to what is; one mark a vertex of each.
Immersion find_immersion(const SoftSkin& from, const SoftSkin& to, Unsure of_from, Unsure of_to);

/// Tells whether something of one of them is deeper in the other than contacts leave it. `cell`: m, the
/// smaller one.
bool is_deep(const Immersion& of_a, const Immersion& of_b, double cell);

/// Tells whether what was found near the surfaces (`found`, gaps of `from` to `to`) asks for a look at all
/// that is inside. It does where something is deeper than contacts leave it, or nothing is near though the
/// first vertex is inside.
bool may_be_immersed(const SoftSkin& from, const SoftSkin& to, std::span<const VertexMeeting> found);

/// Returns the direction (unit, from b to a) in which two bodies part. `between_middles`: from b's middle to
/// a's, m.
Vec3 way_apart(const Immersion& of_a, const Immersion& of_b, const Vec3& between_middles);

/// Tells whether this vertex' nearest way out goes against that of the bodies, `along`: it has come through.
bool came_through(const VertexMeeting& inside, const Vec3& along, double cell);

/// Returns how the bodies are led apart in this tick of h s, after `before`, what was known of them; none:
/// contacts press them apart by themselves. `cell`: m, the smaller one. All that is inside is led
///   where it is deeper than contacts look,
///   where what came through has not gone back at once,
///   and where, though nobody presses them (`pressed`), they stay deep.
std::optional<Entanglement> lead_apart(const Immersion& of_a, const Immersion& of_b,
                                       const Vec3& between_middles, const Entanglement* before, bool pressed,
                                       double cell, double h);

}  // namespace prosector
