#pragma once
// Spheres, capsules and cylinders as segments with a radius; closest points of a segment and a triangle.

#include <array>
#include <optional>

#include "server/physics/mechanics/collision/shapes/shape.h"

namespace prosector::contact {

/// Capsule in the world frame: all points within `radius` of a segment.
struct Rod {
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();  // m: ends of the segment
  double radius = 0;                            // m
  Vec3 lo = Vec3::Zero(), hi = Vec3::Zero();    // m, box around it
};

/// Returns a collision part as a capsule in the room frame. `pose`: of the part, in the room frame. A sphere
/// becomes a capsule whose segment has length 0, a cylinder the largest capsule inside it. Returns none for
/// other shapes.
std::optional<Rod> rod_of(const collision::ShapePart& part, const Pose& pose);

/// Closest points of a segment and a triangle, with their distance.
struct SegmentTriangle {
  Vec3 weights = Vec3::Zero();     // barycentric, of the triangle's closest point
  Vec3 on_segment = Vec3::Zero();  // m
  double distance = 0;             // m; 0: the segment intersects the triangle
};

/// Returns the closest points of the segment from–to and a triangle (Ericson, Real-Time Collision Detection,
/// 5.1.10). They belong to an end of the segment and the triangle, or to the segment and an edge, or are
/// their intersection.
SegmentTriangle closest(const Vec3& from, const Vec3& to, const std::array<Vec3, 3>& triangle);

}  // namespace prosector::contact
