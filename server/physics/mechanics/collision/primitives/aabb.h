#pragma once
// Axis-aligned bounding box.

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/math.h"

namespace prosector::collision {

/// Axis-aligned bounding box from corner `lo` to corner `hi`, m. A default-constructed box is empty: lo > hi,
/// and it overlaps nothing.
struct Aabb {
  Vec3 lo = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 hi = Vec3::Constant(-std::numeric_limits<double>::infinity());

  void add(const Vec3& x) {
    lo = lo.cwiseMin(x);
    hi = hi.cwiseMax(x);
  }
  void add(const Aabb& box) {
    lo = lo.cwiseMin(box.lo);
    hi = hi.cwiseMax(box.hi);
  }
  Vec3 center() const { return (lo + hi) / 2; }
  Vec3 half() const { return (hi - lo) / 2; }
  Aabb grown(double by) const { return {lo.array() - by, hi.array() + by}; }
  /// Returns whether the two boxes overlap; boxes that only touch overlap, too.
  bool overlaps(const Aabb& b) const {
    return (lo.array() <= b.hi.array()).all() && (b.lo.array() <= hi.array()).all();
  }
  bool contains(const Aabb& b) const {
    return (lo.array() <= b.lo.array()).all() && (b.hi.array() <= hi.array()).all();
  }
  double area() const {
    const Vec3 d = hi - lo;
    return 2 * (d.x() * d.y() + d.y() * d.z() + d.z() * d.x());
  }
  /// Returns the squared distance of the two boxes, m²; 0 if they overlap.
  double squared_distance(const Aabb& b) const {
    return (lo - b.hi).cwiseMax(b.lo - hi).cwiseMax(0).squaredNorm();
  }
  double squared_distance(const Vec3& x) const { return (lo - x).cwiseMax(x - hi).cwiseMax(0).squaredNorm(); }
};

/// Returns the axis-aligned box around `box` after a rotation and a translation. `rotation`: rotation matrix,
/// applied first. `shift`: translation, m.
inline Aabb transformed(const Aabb& box, const Mat3& rotation, const Vec3& shift) {
  const Vec3 center = rotation * box.center() + shift, half = rotation.cwiseAbs() * box.half();
  return {center - half, center + half};
}

}  // namespace prosector::collision
