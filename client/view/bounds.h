#pragma once
// Balls around what is drawn.

#include <span>

#include "client/view/draw_list.h"

namespace prosector {

struct Sphere {
  Vec3 center = Vec3::Zero();
  double radius = 0;  // m
};

inline Eigen::AlignedBox3f box_of(std::span<const Eigen::Vector3f> points) {
  Eigen::AlignedBox3f box;
  for (const auto& x : points) box.extend(x);
  return box;
}

/// Returns a ball around the points, about the middle of their box.
inline Sphere bounds_of(std::span<const Eigen::Vector3f> points) {
  if (points.empty()) return {};
  const Eigen::Vector3f center = box_of(points).center();
  float squared = 0;
  for (const auto& x : points) squared = std::max(squared, (x - center).squaredNorm());
  return {center.cast<double>(), std::sqrt(static_cast<double>(squared))};
}

/// Returns the largest stretch of the item's shape, or more: the Frobenius norm is never below it.
inline double stretch_of(const DrawItem& item) {
  return item.shape.A.isIdentity(0) ? 1 : item.shape.A.norm();
}

/// Returns a ball in the room around a ball in the frame of the item's mesh.
inline Sphere placed(const Sphere& sphere, const DrawItem& item) {
  return {item.shape * (item.pose * sphere.center), sphere.radius * stretch_of(item)};
}

}  // namespace prosector
