#pragma once
// Collision shapes at any fidelity: four kinds of shapes, and the proximity of each pair of kinds.

#include <memory>
#include <optional>
#include <variant>

#include "server/physics/mechanics/collision/narrow/box_contact.h"
#include "server/physics/mechanics/collision/narrow/surface_contact.h"
#include "server/physics/mechanics/collision/shapes/convex.h"

namespace prosector::collision {

struct ConvexShape {
  std::shared_ptr<const FacetedConvex> convex;
  Pose pose;  // in the world frame
};

using CollisionPiece = std::variant<SphereShape, BoxShape, ConvexShape, MeshShape>;

/// Returns the distance or the penetration depth of two collision pieces, with normal and closest points.
/// Returns nothing if they are farther apart than `margin`, m.
///
/// Two spheres, or a sphere and a box, are solved in closed form. Two boxes use the separating axis test.
/// Other pairs without a mesh use GJK and EPA. A sphere and a mesh use the signed distance of the sphere's
/// centre. All other pairs with a mesh are tested as two triangle surfaces.
std::optional<Proximity> proximity(const CollisionPiece& a, const CollisionPiece& b, double margin);

/// Returns the axis-aligned bounding box of a collision piece in the world frame, its rounding included.
Aabb box_of(const CollisionPiece& piece);

inline bool is_mesh(const CollisionPiece& piece) {
  return std::holds_alternative<MeshShape>(piece);
}

}  // namespace prosector::collision
