#pragma once
// A place on a triangle near to a point.

#include <array>

#include "common/math.h"

namespace prosector {

struct PlaceOnTriangle {
  std::array<float, 2> weights{};  // of the second and third corner
  Eigen::Vector3f at = Eigen::Vector3f::Zero();
};

/// Returns the foot on the triangle's plane; where that lies beyond the border, a place on the border, which
/// need not be the nearest.
inline PlaceOnTriangle place_near(const Eigen::Vector3f& x, const Eigen::Vector3f& a,
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
