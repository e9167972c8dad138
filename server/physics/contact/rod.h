#pragma once
// Spheres, capsules and cylinders as segments with a radius, and the closest points of a segment and a
// triangle.

#include <array>
#include <optional>

#include "server/physics/collision/shapes/shape.h"

namespace prosector {

/// A capsule: all points within `radius` of the segment; world frame.
struct Rod {
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();  // m
  double radius = 0;                            // m
  Vec3 lo = Vec3::Zero(), hi = Vec3::Zero();    // m, box around it
};

/// Returns the part as a rod, `pose` the part's in the room: a sphere has no length, a cylinder becomes the
/// capsule inside it. Nothing for other shapes.
std::optional<Rod> rod_of(const ShapePart& part, const Pose& pose);

struct SegmentTriangle {
  Vec3 weights = Vec3::Zero();     // of the triangle's corners at its closest point
  Vec3 on_segment = Vec3::Zero();  // m
  double distance = 0;             // m; 0: the segment passes through
};

/// Finds the closest points of a segment and a triangle (Ericson, Real-Time Collision Detection, 5.1.10).
/// They are of an end and the triangle, or of the segment and an edge, or where it passes through.
SegmentTriangle closest(const Vec3& from, const Vec3& to, const std::array<Vec3, 3>& triangle);

}  // namespace prosector
