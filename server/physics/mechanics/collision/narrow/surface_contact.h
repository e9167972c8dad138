#pragma once
// Contact of triangle surfaces with each other and with spheres.

#include <memory>
#include <optional>

#include "server/physics/mechanics/collision/narrow/box_contact.h"
#include "server/physics/mechanics/collision/primitives/proximity.h"
#include "server/physics/mechanics/collision/surface/triangle_surface.h"

namespace prosector {

struct MeshShape {
  std::shared_ptr<const TriangleSurface> surface;
  Pose pose;            // of the surface's frame in the world frame
  double rounding = 0;  // m: half of a sheet's thickness
};

/// Returns the distance or depth of two surfaces. If they are separated, it is their distance. If they cross,
/// or one is inside the other, it is the pointwise depth. That is the largest distance from a point of one
/// surface inside the other to the other's surface.
///
/// The normal points along the shortest path from the deepest point to the outside. Candidates for the
/// deepest point are the vertices, and samples on the edge segments cut off by the other surface. For convex
/// shapes with a small overlap the depth is the minimum translation, for others a lower bound. Open surfaces
/// have no inside: if no point is inside a closed surface, a crossing has gap 0 minus the roundings.
std::optional<Proximity> surface_proximity(const MeshShape& a, const MeshShape& b, double margin);

/// Returns the proximity of a sphere and a surface from the signed distance of the centre.
std::optional<Proximity> sphere_surface_proximity(const SphereShape& a, const MeshShape& b, double margin);

}  // namespace prosector
