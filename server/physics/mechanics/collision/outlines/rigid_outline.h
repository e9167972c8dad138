#pragma once
// Collision shape of a rigid body at one fidelity, shared by all bodies of the same shape.

#include <memory>
#include <span>
#include <vector>

#include "common/fidelity.h"
#include "server/physics/mechanics/collision/narrow/collision_piece.h"
#include "server/physics/mechanics/collision/outlines/bounding.h"

namespace prosector::collision {

/// Collision shape of a rigid body that consists of parts. The fidelity selects the shape:
///   none: no shape;
///   sphere: one sphere that encloses the triangles of all parts;
///   aabb: one box along the world axes that encloses the triangles of all parts, refitted at each pose;
///   obb: one oriented box that encloses the triangles of all parts and rotates with the body;
///   hull: one convex shape per part. Box, sphere, capsule, cylinder and ellipsoid are exact, and a mesh is
///         replaced by its convex hull;
///   mesh: each part's triangles. Round parts are tessellated to within chord_error, or with 48
///         segments around.
class RigidOutline {
 public:
  /// Builds the collision shape at this fidelity. Throws InputError for an empty list, and for a part whose
  /// size, mesh or pose is invalid.
  RigidOutline(std::vector<ShapePart> parts, Fidelity fidelity);

  Fidelity fidelity() const { return fidelity_; }
  std::size_t parts() const { return parts_.size(); }
  /// Returns the pose of each part in the body's frame when no part is displaced.
  std::vector<Pose> rest_poses() const;
  /// Replaces the content of `out` by the body's collision pieces in the world frame. `pose`: the body's pose
  /// in the world frame. `part_poses`: the current pose of each part in the body's frame.
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
  /// Calls `fit` with the outlines of all parts, transformed by `part_poses`, and returns the bounding shape
  /// that `fit` computes.
  template <class Fit>
  auto fit(std::span<const Pose> part_poses, const Fit& fit) const;

  Fidelity fidelity_;
  std::vector<Part> parts_;
  SphereShape rest_sphere_;  // in the body frame
  BoxShape rest_box_;        // in the body frame
};

}  // namespace prosector::collision
