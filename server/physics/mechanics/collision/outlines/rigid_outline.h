#pragma once
// Collision shape of a rigid body at one fidelity, shared by all bodies of the same shape.

#include <memory>
#include <span>
#include <vector>

#include "server/physics/mechanics/collision/narrow/collision_piece.h"
#include "server/physics/mechanics/collision/outlines/bounding.h"
#include "server/physics/mechanics/collision/shapes/fidelity.h"

namespace prosector {

/// Collision shape of a rigid body. The fidelity selects the shape:
///   none    no shape
///   sphere  one sphere that encloses the mesh shape
///   aabb    one world-axis box that encloses the mesh shape, refitted at each pose
///   obb     one box that encloses the mesh shape and rotates with the body
///   hull    one convex shape per part: box, sphere, capsule, cylinder and ellipsoid exactly,
///           meshes by their hull; encloses the mesh shape
///   mesh    each part's triangles: round parts within chord_error or 48 segments around
class RigidOutline {
 public:
  /// Throws InputError for a part without a valid size, and for an empty list.
  RigidOutline(std::vector<ShapePart> parts, Fidelity fidelity);

  Fidelity fidelity() const { return fidelity_; }
  std::size_t parts() const { return parts_.size(); }
  /// Returns the poses of the parts in the body frame at rest.
  std::vector<Pose> rest_poses() const;
  /// Fills `out` with the collision pieces of a body at `pose`. `part_poses`: the current poses of the parts
  /// in the body frame.
  void place(const Pose& pose, std::span<const Pose> part_poses, std::vector<CollisionPiece>& out) const;

 private:
  struct Part {
    ShapePart shape;
    std::shared_ptr<const FacetedConvex> convex;     // hull, if the part is neither box nor sphere
    std::shared_ptr<const TriangleSurface> surface;  // mesh
    std::vector<Vec3> outline;                       // sphere, aabb and obb: points …
    double rounding = 0;                             // … each a ball of this radius, m
  };
  Part make_part(const ShapePart& shape) const;
  /// Fits one shape to all parts, in the frame of `part_poses`.
  template <class Fit>
  auto fit(std::span<const Pose> part_poses, const Fit& fit) const;

  Fidelity fidelity_;
  std::vector<Part> parts_;
  SphereShape rest_sphere_;  // in the body frame
  BoxShape rest_box_;        // in the body frame
};

}  // namespace prosector
