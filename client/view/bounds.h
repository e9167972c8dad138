#pragma once
// Bounding spheres of drawn items.

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

/// Returns a sphere around all points, centred on the centre of their bounding box.
inline Sphere bounds_of(std::span<const Eigen::Vector3f> points) {
  if (points.empty()) return {};
  const Eigen::Vector3f center = box_of(points).center();
  float squared = 0;
  for (const auto& x : points) squared = std::max(squared, (x - center).squaredNorm());
  return {center.cast<double>(), std::sqrt(static_cast<double>(squared))};
}

/// Returns an upper bound of the factor by which the item's shape (a linear map) stretches any direction. It
/// is the map's Frobenius norm, which is never smaller than the largest stretch.
inline double stretch_of(const DrawItem& item) {
  return item.shape.A.isIdentity(0) ? 1 : item.shape.A.norm();
}

/// Returns a bounding sphere in the world frame for a sphere given in the frame of the item's mesh.
inline Sphere placed(const Sphere& sphere, const DrawItem& item) {
  return {item.shape * (item.pose * sphere.center), sphere.radius * stretch_of(item)};
}

}  // namespace prosector
