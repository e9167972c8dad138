#pragma once
// Collision shapes at any fidelity: four kinds of shapes, and the proximity of each pair of kinds.

#include <memory>
#include <optional>
#include <variant>

#include "server/physics/mechanics/collision/narrow/box_contact.h"
#include "server/physics/mechanics/collision/narrow/surface_contact.h"
#include "server/physics/mechanics/collision/shapes/convex.h"

namespace prosector {

struct ConvexShape {
  std::shared_ptr<const FacetedConvex> convex;
  Pose pose;  // in the world frame
};

using CollisionPiece = std::variant<SphereShape, BoxShape, ConvexShape, MeshShape>;

/// Returns the distance or the penetration depth of two pieces. Returns nothing if they are farther apart
/// than `margin`. Seven kernels cover all sixteen pairs of kinds:
///
///            sphere   box      convex   mesh
///   sphere   closed   closed   GJK      signed distance of the centre
///   box               SAT      GJK      as triangle surfaces
///   convex                     GJK      as triangle surfaces
///   mesh                                as triangle surfaces
std::optional<Proximity> proximity(const CollisionPiece& a, const CollisionPiece& b, double margin);

/// Returns the axis-aligned bounding box of the piece in the world frame.
Aabb box_of(const CollisionPiece& piece);

inline bool is_mesh(const CollisionPiece& piece) {
  return std::holds_alternative<MeshShape>(piece);
}

}  // namespace prosector
