#pragma once
// What objects are made of for collision, whatever their fidelity: four kinds of shapes, and all pairs of
// them.

#include <memory>
#include <optional>
#include <variant>

#include "server/physics/collision/narrow/box_contact.h"
#include "server/physics/collision/narrow/surface_contact.h"
#include "server/physics/collision/shapes/convex.h"

namespace prosector {

struct ConvexShape {
  std::shared_ptr<const FacetedConvex> convex;
  Pose pose;  // in the room
};

using CollisionPiece = std::variant<SphereShape, BoxShape, ConvexShape, MeshShape>;

/// Tells how near, or how deep. Nothing when farther apart than `margin`. Seven kernels do all sixteen pairs:
///
///            sphere   box      convex   mesh
///   sphere   closed   closed   GJK      signed distance of the centre
///   box               SAT      GJK      as surfaces of triangles
///   convex                     GJK      as surfaces of triangles
///   mesh                                as surfaces of triangles
std::optional<Proximity> proximity(const CollisionPiece& a, const CollisionPiece& b, double margin);

/// Returns the box around the piece in the world frame.
Aabb box_of(const CollisionPiece& piece);

inline bool is_mesh(const CollisionPiece& piece) {
  return std::holds_alternative<MeshShape>(piece);
}

}  // namespace prosector
