#pragma once
// Closed-form contact of boxes and spheres.

#include <array>
#include <cstddef>
#include <optional>

#include "server/physics/mechanics/collision/primitives/proximity.h"

namespace prosector::collision {

struct SphereShape {
  Vec3 center = Vec3::Zero();  // m
  double radius = 0;           // m
};

struct BoxShape {
  Pose pose;  // of its centre, with the box axes as frame axes
  Vec3 half = Vec3::Zero();
};

/// Contact of two overlapping boxes: depth, normal and contact patch. It is found by the separating axis test
/// (Gottschalk, Lin and Manocha 1996, "OBBTree"). The 15 axes are 3 + 3 face normals and 9 edge cross
/// products. The axis of least overlap gives the minimum translation that separates the boxes.
struct BoxOverlap {
  Proximity proximity;  // its point is the centre of the patch
  // Corners of the contact patch, m: a clipped face, or one point for two crossing edges.
  std::array<Vec3, 8> patch;
  std::size_t count = 0;
};
/// Returns the depth, normal and contact patch of two overlapping boxes, in the frame of their poses. Returns
/// nothing if the boxes do not overlap.
std::optional<BoxOverlap> box_overlap(const BoxShape& a, const BoxShape& b);

/// Returns the distance or the penetration depth of two boxes, with normal and closest points: by box_overlap
/// if they overlap, else by GJK. Returns nothing if they are farther apart than `margin`, m.
std::optional<Proximity> box_proximity(const BoxShape& a, const BoxShape& b, double margin);
std::optional<Proximity> sphere_proximity(const SphereShape& a, const SphereShape& b, double margin);
/// Returns the distance or the penetration depth of a sphere and a box, with normal and closest points. If
/// the sphere's centre is inside the box, the normal is that of the nearest face. Returns nothing if they are
/// farther apart than `margin`, m.
std::optional<Proximity> sphere_box_proximity(const SphereShape& a, const BoxShape& b, double margin);

}  // namespace prosector::collision
