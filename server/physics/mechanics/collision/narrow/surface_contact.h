#pragma once
// Contact of triangle surfaces with each other and with spheres.

#include <memory>
#include <optional>

#include "server/physics/mechanics/collision/narrow/box_contact.h"
#include "server/physics/mechanics/collision/primitives/proximity.h"
#include "server/physics/mechanics/collision/surface/triangle_surface.h"

namespace prosector::collision {

struct MeshShape {
  std::shared_ptr<const TriangleSurface> surface;
  Pose pose;            // of the surface's frame in the world frame
  double rounding = 0;  // m: half of a sheet's thickness
};

/// Returns the distance or the penetration depth of two triangle surfaces, with normal and closest points. If
/// they are separated, it is their distance. If they cross, or one is inside the other, it is the pointwise
/// depth: the largest distance from a point of one surface, inside the other, to the other's surface. Returns
/// nothing if they are farther apart than `margin`, m.
///
/// The normal points along the shortest path from the deepest point to the outside. Candidates for the
/// deepest point are the vertices, and samples on the edge segments cut off by the other surface. For convex
/// shapes with a small overlap the depth is the minimum translation, for others a lower bound. Open surfaces
/// have no inside. If no point is inside a closed surface, surfaces that cross have gap 0, from which both
/// roundings are subtracted.
std::optional<Proximity> surface_proximity(const MeshShape& a, const MeshShape& b, double margin);

/// Returns the distance or the penetration depth of a sphere and a triangle surface, with normal and closest
/// points, from the signed distance of the sphere's centre. Returns nothing if they are farther apart than
/// `margin`, m.
std::optional<Proximity> sphere_surface_proximity(const SphereShape& a, const MeshShape& b, double margin);

}  // namespace prosector::collision
