#pragma once
// Collision parts of a rigid body: each is convex or a triangle mesh, in the body's centre-of-mass frame.

#include <memory>
#include <vector>

#include "common/mesh.h"

namespace prosector {

enum class ShapeKind : std::uint8_t { box, sphere, capsule, cylinder, ellipsoid, hull, triangles };

/// One part of a body's collision shape. Capsules and cylinders are aligned with local y.
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

/// Returns the part's mass properties in the parent frame of `part.pose`; density in kg/m³. Primitives use
/// closed forms; meshes use signed tetrahedra over the surface (Mirtich 1996). A mesh must be closed.
MassProperties part_mass(const ShapePart& part, double density);

/// Combines mass properties by the parallel-axis theorem.
MassProperties combine(const std::vector<MassProperties>& parts);

/// Bounding box of a part in the part's frame: half extents about `center`, m.
struct Extent {
  Vec3 center;
  Vec3 half;
};
Extent part_extent(const ShapePart& part);

/// Returns the convex hull of points as a closed triangle mesh.
TriangleMesh convex_hull(const std::vector<Vec3>& points);

}  // namespace prosector
