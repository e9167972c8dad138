#include "server/physics/mechanics/collision/primitives/closest_points.h"

#include <algorithm>
#include <limits>

namespace prosector::collision {

Vec3 closest_weights(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  const Vec3 bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return {1 - d1 / (d1 - d3), d1 / (d1 - d3), 0};
  const Vec3 cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return {1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)};
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double t = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0, 1 - t, t};
  }
  const double sum = va + vb + vc;
  if (!(sum > 0)) return {1, 0, 0};
  return {va / sum, vb / sum, vc / sum};
}

SegmentParameters closest_parameters(const Vec3& p, const Vec3& d, const Vec3& q, const Vec3& e) {
  const Vec3 r = p - q;
  const double a = d.squaredNorm(), b = d.dot(e), c = d.dot(r), f = e.dot(r), ee = e.squaredNorm();
  if (!(ee > 0)) return {a > 0 ? std::clamp(-c / a, 0.0, 1.0) : 0, 0};
  if (!(a > 0)) return {0, std::clamp(f / ee, 0.0, 1.0)};
  const double denominator = a * ee - b * b;
  double s = denominator > 0 ? std::clamp((b * f - c * ee) / denominator, 0.0, 1.0) : 0;
  double t = (b * s + f) / ee;
  if (t < 0 || t > 1) {
    t = std::clamp(t, 0.0, 1.0);
    s = std::clamp((b * t - c) / a, 0.0, 1.0);
  }
  return {s, t};
}

TrianglePair closest(const Triangle& a, const Triangle& b) {
  TrianglePair best;
  best.squared_distance = std::numeric_limits<double>::infinity();
  const auto offer = [&](const Vec3& on_a, const Vec3& on_b, const Vec3& weights_a, const Vec3& weights_b) {
    const double d = (on_a - on_b).squaredNorm();
    if (d < best.squared_distance) best = {weights_a, weights_b, on_a, on_b, d};
  };
  for (Eigen::Index k = 0; k < 3; ++k) {
    const Vec3 corner = Vec3::Unit(k);
    const Vec3 &of_a = a[static_cast<std::size_t>(k)], &of_b = b[static_cast<std::size_t>(k)];
    const Vec3 on_b = closest_weights(of_a, b[0], b[1], b[2]);
    offer(of_a, at(b, on_b), corner, on_b);
    const Vec3 on_a = closest_weights(of_b, a[0], a[1], a[2]);
    offer(at(a, on_a), of_b, on_a, corner);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t i1 = (i + 1) % 3;
    const Vec3 d = a[i1] - a[i];
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t j1 = (j + 1) % 3;
      const Vec3 e = b[j1] - b[j];
      const auto [s, t] = closest_parameters(a[i], d, b[j], e);
      Vec3 weights_a = Vec3::Zero(), weights_b = Vec3::Zero();
      weights_a[static_cast<Eigen::Index>(i)] = 1 - s;
      weights_a[static_cast<Eigen::Index>(i1)] = s;
      weights_b[static_cast<Eigen::Index>(j)] = 1 - t;
      weights_b[static_cast<Eigen::Index>(j1)] = t;
      offer(a[i] + s * d, b[j] + t * e, weights_a, weights_b);
    }
  }
  return best;
}

}  // namespace prosector::collision
