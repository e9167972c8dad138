#pragma once
// Surfaces of triangles against each other and against spheres.

#include <memory>
#include <optional>

#include "server/physics/collision/narrow/box_contact.h"
#include "server/physics/collision/primitives/proximity.h"
#include "server/physics/collision/surface/triangle_surface.h"

namespace prosector {

struct MeshShape {
  std::shared_ptr<const TriangleSurface> surface;
  Pose pose;            // of its positions in the room
  double rounding = 0;  // m: half of a sheet's thickness
};

/// Finds how near, or how deep, two surfaces are. Apart, that is their distance. Where they cross, or one is
/// inside the other, it is the pointwise depth: the farthest that a point of one surface inside the other is
/// from the other's surface. The normal leads that point out the shortest way. The point is looked for among
/// corners, and along those parts of edges that the other surface cuts off. For convex shapes that overlap a
/// little this is the shortest way apart, for others a lower bound. Open surfaces have no inside: where
/// nothing is inside a closed one, a crossing has gap 0 (less the roundings).
std::optional<Proximity> surface_proximity(const MeshShape& a, const MeshShape& b, double margin);

/// Finds the proximity by the signed distance of the centre.
std::optional<Proximity> sphere_surface_proximity(const SphereShape& a, const MeshShape& b, double margin);

}  // namespace prosector
