#pragma once
// A point on a triangle near a given point.

#include <array>

#include "common/math.h"

namespace prosector {

struct PointOnTriangle {
  std::array<float, 2> weights{};  // of the second and third corner
  Eigen::Vector3f at = Eigen::Vector3f::Zero();
};

/// Returns the projection of `x` onto the plane of the triangle a, b, c. If it is outside the triangle,
/// returns a point on the triangle's border, not necessarily the nearest.
inline PointOnTriangle point_on_triangle_near(const Eigen::Vector3f& x, const Eigen::Vector3f& a,
                                              const Eigen::Vector3f& b, const Eigen::Vector3f& c) {
  const Eigen::Vector3f u = b - a, v = c - a, w = x - a;
  const float uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), determinant = uu * vv - uv * uv;
  Eigen::Vector3f weights(1, 0, 0);
  if (determinant > 0) {
    const float s = (vv * w.dot(u) - uv * w.dot(v)) / determinant;
    const float t = (uu * w.dot(v) - uv * w.dot(u)) / determinant;
    weights = Eigen::Vector3f(1 - s - t, s, t).cwiseMax(0);
    weights /= weights.sum();
  }
  return {{weights[1], weights[2]}, weights[0] * a + weights[1] * b + weights[2] * c};
}

}  // namespace prosector
