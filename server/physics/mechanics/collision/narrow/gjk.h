#pragma once
// Distance of two convex sets given by their support functions.

#include <algorithm>
#include <array>
#include <cstddef>

#include "server/physics/mechanics/collision/primitives/closest_points.h"

namespace prosector::collision {

struct ClosestPoints {
  bool apart = false;  // false: the sets overlap, or are closer than rounding; the points are not set
  Vec3 on_a = Vec3::Zero(), on_b = Vec3::Zero();
};

/// Closest points of two convex sets by the algorithm of Gilbert, Johnson and Keerthi (GJK, 1988), in double
/// precision. It adds support points of the Minkowski difference a − b to a simplex until no support point is
/// closer to the origin. The simplex's point closest to the origin is computed with closest_points.h, for a
/// tetrahedron from its four faces.
class Gjk {
 public:
  /// Returns the closest points of two convex sets a and b; only `apart` = false if the sets overlap.
  /// `farthest_a` and `farthest_b` are their support functions Vec3(const Vec3& direction). `start`: any
  /// non-zero vector, best the vector from b to a. `size`: approximate size of the sets, m, which scales the
  /// tolerance for touching sets.
  template <class A, class B>
  static ClosestPoints run(const A& farthest_a, const B& farthest_b, const Vec3& start, double size);

 private:
  struct Corner {
    Vec3 on_a, on_b, difference;
  };
  /// Computes the weights of the simplex's point closest to the origin, and drops the corners with weight 0.
  /// Returns false, and drops nothing, if the origin is inside the simplex (a tetrahedron).
  bool reduce();
  bool origin_inside() const;
  void keep(const std::array<std::size_t, 3>& which, const Vec3& weights);
  Vec3 nearest() const;

  std::array<Corner, 4> corners_;
  std::array<double, 4> weights_{};
  std::size_t count_ = 0;
};

template <class A, class B>
ClosestPoints Gjk::run(const A& farthest_a, const B& farthest_b, const Vec3& start, double size) {
  constexpr int most_steps = 128;  // round shapes need about thirty steps
  // Relative to the squared distance: stops when the next support point improves it by less.
  constexpr double nothing_nearer = 1e-13;
  const double touching = 1e-14 * size;
  Gjk gjk;
  const auto corner = [&](const Vec3& way) {
    const Vec3 a = farthest_a(-way), b = farthest_b(way);
    return Corner{a, b, a - b};
  };
  gjk.corners_[0] = corner(start);
  gjk.weights_[0] = 1;
  gjk.count_ = 1;
  Vec3 way = gjk.corners_[0].difference;
  Gjk best = gjk;
  for (int step = 0; step < most_steps; ++step) {
    if (!(way.norm() > touching)) return {};
    const Corner next = corner(way);
    if (way.squaredNorm() - way.dot(next.difference) <= nothing_nearer * way.squaredNorm()) break;
    gjk.corners_[gjk.count_++] = next;
    if (!gjk.reduce()) return {};
    const Vec3 nearer = gjk.nearest();
    if (!(nearer.squaredNorm() < way.squaredNorm())) break;  // only rounding errors remain
    way = nearer;
    best = gjk;
  }
  ClosestPoints out{true, Vec3::Zero(), Vec3::Zero()};
  for (std::size_t i = 0; i < best.count_; ++i) {
    out.on_a += best.weights_[i] * best.corners_[i].on_a;
    out.on_b += best.weights_[i] * best.corners_[i].on_b;
  }
  return out;
}

}  // namespace prosector::collision
