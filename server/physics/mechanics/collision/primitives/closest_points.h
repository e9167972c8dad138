#pragma once
// Closest points between points, segments and triangles (Ericson, Real-Time Collision Detection, 2005, 5.1).
// Degenerate triangles are treated as segments, degenerate segments as points.

#include <array>

#include "common/math.h"

namespace prosector::collision {

using Triangle = std::array<Vec3, 3>;  // m

/// Returns the barycentric weights, for corners a, b and c, of the triangle's point closest to p (Ericson,
/// Real-Time Collision Detection, 5.1.5). A weight is exactly 0 if that point lies on the opposite edge or on
/// another corner.
Vec3 closest_weights(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

struct SegmentParameters {
  double s, t;  // in [0, 1] along the first and the second segment
};

/// Returns the parameters s and t, in [0, 1], of the closest points p + s·d and q + t·e of two segments
/// (Ericson, Real-Time Collision Detection, 5.1.9). The segments start at p and q; d and e are the vectors to
/// their ends.
SegmentParameters closest_parameters(const Vec3& p, const Vec3& d, const Vec3& q, const Vec3& e);

struct TrianglePair {
  Vec3 weights_a = Vec3::Zero(), weights_b = Vec3::Zero();  // barycentric, of the corners
  Vec3 on_a = Vec3::Zero(), on_b = Vec3::Zero();            // m
  double squared_distance = 0;                              // m²
};

/// Returns the closest points of two triangles: of a corner and a face, or of two edges (Ericson, Real-Time
/// Collision Detection, 5.1.10). For triangles that cross, it returns the closest corner–face or edge–edge
/// pair, whose distance may exceed 0.
TrianglePair closest(const Triangle& a, const Triangle& b);

inline Vec3 at(const Triangle& t, const Vec3& weights) {
  return weights[0] * t[0] + weights[1] * t[1] + weights[2] * t[2];
}

}  // namespace prosector::collision
