#pragma once
// Collision parts of a rigid body: each is convex or a triangle mesh, in the body's centre-of-mass frame.

#include <memory>
#include <vector>

#include "common/mesh.h"

namespace prosector::collision {

enum class ShapeKind : std::uint8_t { box, sphere, capsule, cylinder, ellipsoid, hull, triangles };

/// One part of a rigid body's collision shape: a primitive, or a mesh. Capsules and cylinders are aligned
/// with the y axis of the part's frame.
struct ShapePart {
  ShapeKind kind = ShapeKind::box;
  Vec3 half = Vec3::Zero();  // m: box, ellipsoid: half extents; sphere, capsule, cylinder: radius in x;
                             // capsule: half length of its segment in y; cylinder: half height in y
  Pose pose;                 // of the part in the body's centre-of-mass frame
  std::shared_ptr<const TriangleMesh> mesh;  // hull, triangles: in the part's frame
};

/// Mass, centre of mass and inertia tensor of a solid.
struct MassProperties {
  double mass = 0;              // kg
  Vec3 center = Vec3::Zero();   // m
  Mat3 inertia = Mat3::Zero();  // kg·m², about `center`
};

/// Returns the part's mass, centre of mass and inertia, in the frame in which `part.pose` is given; `density`
/// in kg/m³. Primitives use closed forms. Meshes sum signed tetrahedra over the surface (Mirtich 1996), so a
/// mesh must be closed.
MassProperties part_mass(const ShapePart& part, double density);

/// Returns the total mass, the common centre of mass and the inertia of several solids, by the parallel-axis
/// theorem. All are given in the same frame. All results are zero if the total mass is zero.
MassProperties combine(const std::vector<MassProperties>& parts);

/// Axis-aligned bounding box of a collision part, in the part's frame: half extents `half` about `center`, m.
struct Extent {
  Vec3 center;
  Vec3 half;
};
Extent part_extent(const ShapePart& part);

/// Returns the convex hull of points as a closed triangle mesh. The hull is computed by Bullet with rounded
/// coordinates.
TriangleMesh convex_hull(const std::vector<Vec3>& points);

}  // namespace prosector::collision
