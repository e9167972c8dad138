#pragma once
// What a rigid body is made of for collision: parts, each convex or a triangle mesh, in the frame of the
// body's centre of mass.

#include <memory>
#include <vector>

#include "common/mesh.h"

namespace prosector {

enum class ShapeKind : std::uint8_t { box, sphere, capsule, cylinder, ellipsoid, hull, triangles };

/// One part. Capsules and cylinders stand along local y.
struct ShapePart {
  ShapeKind kind = ShapeKind::box;
  Vec3 half = Vec3::Zero();  // m: box, ellipsoid: half extents; sphere, capsule, cylinder: radius in x;
                             // capsule: half length of its segment in y; cylinder: half height in y
  Pose pose;                 // of the part in the body's centre-of-mass frame
  std::shared_ptr<const TriangleMesh> mesh;  // hull, triangles: in the part's frame
};

/// Mass, centre and inertia of a solid.
struct MassProperties {
  double mass = 0;              // kg
  Vec3 center = Vec3::Zero();   // m
  Mat3 inertia = Mat3::Zero();  // kg·m², about `center`
};

/// Returns the part's mass properties in the frame that `part.pose` leads to. They are closed forms for
/// primitives, and signed tetrahedra over the surface for meshes (Mirtich 1996). A mesh must be closed.
MassProperties part_mass(const ShapePart& part, double density);

/// Combines mass properties by the parallel-axis theorem.
MassProperties combine(const std::vector<MassProperties>& parts);

/// Half extents of the box around a part in its own frame, about `center`.
struct Extent {
  Vec3 center;
  Vec3 half;
};
Extent part_extent(const ShapePart& part);

/// Returns the convex hull of points as a closed triangle mesh.
TriangleMesh convex_hull(const std::vector<Vec3>& points);

}  // namespace prosector
