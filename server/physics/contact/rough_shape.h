#pragma once
// A soft body as the sphere, box or hull that it collides as.

#include <memory>

#include "server/physics/collision/narrow/collision_piece.h"
#include "server/physics/collision/outlines/bounding.h"
#include "server/physics/collision/shapes/fidelity.h"
#include "server/physics/contact/hanger.h"

namespace prosector {

/// The simple shape that a body collides as, fitted anew to the moved surface in each tick:
///   aabb    a box that lies along the room's axes at rest
///   obb     one along the principal axes then
///   sphere  about the middle of the aabb, out to the farthest vertex
///   hull    of the vertices
///
/// Boxes turn as the body does on the whole, so that turning makes nothing grow into what it touches. All
/// have half the thickness of a sheet or rope around it. What touches it moves the body as a whole, squeezes
/// and shears it evenly (hanger.h): it makes no dents.
class RoughShape {
 public:
  /// Makes the shape at rest. It takes any fidelity but none and mesh; hull: of a surface with triangles.
  RoughShape(const Anatomy& anatomy, Fidelity fidelity);
  /// Fits the shape to the nodes' positions x (3n, m) and those of the surface.
  void fit(const VecX& x, std::span<const Vec3> surface);

  const CollisionPiece& piece() const { return piece_; }
  const Aabb& box() const { return box_; }
  const Hanger& hanger() const { return hanger_; }

 private:
  Quat turned_axes(std::span<const Vec3> surface) const;

  Fidelity fidelity_;
  double rounding_;  // m
  Hanger hanger_;
  std::vector<Vec3> rest_;                    // vertices about their mean …
  Quat rest_axes_ = Quat::Identity();         // … and the axes of their box
  std::shared_ptr<TriangleSurface> surface_;  // hull
  CollisionPiece piece_;
  Aabb box_;
};

}  // namespace prosector
