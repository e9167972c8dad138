#pragma once
// A rigid body's shape at one fidelity: made once, shared by all bodies of that shape.

#include <memory>
#include <span>
#include <vector>

#include "server/physics/collision/narrow/collision_piece.h"
#include "server/physics/collision/outlines/bounding.h"
#include "server/physics/collision/shapes/fidelity.h"

namespace prosector {

/// What each fidelity takes the body for:
///   none    nothing
///   sphere  one sphere, encloses mesh
///   aabb    one box along the room's axes, fitted anew for each pose, encloses mesh
///   obb     one box that turns along, encloses mesh
///   hull    each part by itself as a convex shape: box, sphere, capsule, cylinder and ellipsoid exactly,
///           meshes by their hull; encloses mesh
///   mesh    each part's triangles: round parts within chord_error or 48 segments around
class RigidOutline {
 public:
  /// Throws InputError for parts that have no size, or none at all.
  RigidOutline(std::vector<ShapePart> parts, Fidelity fidelity);

  Fidelity fidelity() const { return fidelity_; }
  std::size_t parts() const { return parts_.size(); }
  /// Poses of the parts in the body when nothing bends.
  std::vector<Pose> rest_poses() const;
  /// Fills `out` with the pieces of a body at that pose, whose parts are at these poses in it.
  void place(const Pose& pose, std::span<const Pose> part_poses, std::vector<CollisionPiece>& out) const;

 private:
  struct Part {
    ShapePart shape;
    std::shared_ptr<const FacetedConvex> convex;     // hull, of what is neither box nor sphere
    std::shared_ptr<const TriangleSurface> surface;  // mesh
    std::vector<Vec3> outline;                       // sphere, aabb and obb: points …
    double rounding = 0;                             // … with balls around them
  };
  Part make_part(const ShapePart& shape) const;
  /// Fits one shape to all parts, in the frame that the poses lead to.
  template <class Fit>
  auto fit(std::span<const Pose> part_poses, const Fit& fit) const;

  Fidelity fidelity_;
  std::vector<Part> parts_;
  SphereShape rest_sphere_;  // in the body's frame
  BoxShape rest_box_;        // in the body's frame
};

}  // namespace prosector
