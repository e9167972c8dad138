#pragma once
// Boxes against each other and against spheres, in closed form.

#include <array>
#include <cstddef>
#include <optional>

#include "server/physics/collision/primitives/proximity.h"

namespace prosector {

struct SphereShape {
  Vec3 center = Vec3::Zero();  // m
  double radius = 0;           // m
};

struct BoxShape {
  Pose pose;  // of its centre and axes
  Vec3 half = Vec3::Zero();
};

/// Depth and normal of the least overlap over the 15 axes that can part two boxes (Gottschalk, Lin and
/// Manocha 1996, "OBBTree"). The axes are 3 + 3 face normals and 9 products of edges. For boxes that overlap
/// that is the shortest way apart.
struct BoxOverlap {
  Proximity proximity;        // its point: the middle of the patch
  std::array<Vec3, 8> patch;  // m, corners of what touches: a clipped face, or one point of two edges
  std::size_t count = 0;
};
/// Returns nothing for boxes that are apart.
std::optional<BoxOverlap> box_overlap(const BoxShape& a, const BoxShape& b);

/// Finds the proximity of overlapping boxes by box_overlap, of others by GJK.
std::optional<Proximity> box_proximity(const BoxShape& a, const BoxShape& b, double margin);
std::optional<Proximity> sphere_proximity(const SphereShape& a, const SphereShape& b, double margin);
/// Finds the proximity of a sphere and a box. A centre inside the box leaves by the nearest face.
std::optional<Proximity> sphere_box_proximity(const SphereShape& a, const BoxShape& b, double margin);

}  // namespace prosector
