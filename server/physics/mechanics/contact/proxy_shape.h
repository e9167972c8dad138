#pragma once
// Proxy shape of a soft body for contact: sphere, box or hull.

#include <memory>

#include "common/fidelity.h"
#include "server/physics/mechanics/collision/narrow/collision_piece.h"
#include "server/physics/mechanics/collision/outlines/bounding.h"
#include "server/physics/mechanics/contact/shape_matching.h"

namespace prosector::contact {

/// Proxy shape that replaces a soft body in contact detection, refitted to the moved surface in each tick:
///   aabb: a box that is aligned with the room's axes at rest;
///   obb: a box along the principal axes at rest;
///   sphere: a sphere around the centre of the aabb, out to the farthest vertex;
///   hull: the convex hull of the vertices.
///
/// Boxes rotate with the mean rotation of the body, so a rotation makes no box grow into its neighbours. For
/// a sheet or rope, each shape is enlarged by half the thickness. Contact forces move the body as a whole,
/// and squeeze and shear it evenly (shape_matching.h): they make no dents.
class ProxyShape {
 public:
  /// Builds the proxy shape of a soft body at rest. Accepts every fidelity except `none` and `mesh`. The
  /// fidelity `hull` requires a surface with triangles.
  ProxyShape(const Anatomy& anatomy, Fidelity fidelity);
  /// Fits the proxy shape to the soft body's current node positions x (three coordinates per node, m) and
  /// surface vertex positions (m).
  void fit(const VecX& x, std::span<const Vec3> surface);

  const collision::CollisionPiece& piece() const { return piece_; }
  const collision::Aabb& box() const { return box_; }
  const ShapeMatching& shape_matching() const { return shape_matching_; }

 private:
  Quat rotated_axes(std::span<const Vec3> surface) const;

  Fidelity fidelity_;
  double rounding_;  // m
  ShapeMatching shape_matching_;
  std::vector<Vec3> rest_;                               // m, vertices at rest relative to their mean
  Quat rest_axes_ = Quat::Identity();                    // axes of the box at rest
  std::shared_ptr<collision::TriangleSurface> surface_;  // for hull
  collision::CollisionPiece piece_;
  collision::Aabb box_;
};

}  // namespace prosector::contact
