#include "server/physics/mechanics/collision/primitives/triangle_crossing.h"

#include <algorithm>
#include <cmath>

namespace prosector::collision {
namespace {

// Relative rounding tolerance: a few units in the last place of the quantities computed below.
constexpr double rounding = 1e-14;

struct Plane {
  Vec3 normal;     // not unit: twice the area
  double size;     // m: longest edge
  Vec3 distances;  // of the other triangle's corners from the plane, times |normal|
  bool flat;       // the triangle has no area, or the other triangle lies in its plane
  bool apart;      // the other triangle lies on one side of the plane
};

Plane plane(const Triangle& of, const Triangle& other) {
  Plane out;
  const Vec3 ab = of[1] - of[0], ac = of[2] - of[0];
  out.normal = ab.cross(ac);
  out.size = std::sqrt(std::max({ab.squaredNorm(), ac.squaredNorm(), (of[2] - of[1]).squaredNorm()}));
  const double length = out.normal.norm();
  double reach = out.size;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const Vec3 to = other[static_cast<std::size_t>(k)] - of[0];
    reach = std::max(reach, to.lpNorm<Eigen::Infinity>());
    out.distances[k] = out.normal.dot(to);
  }
  const double least = rounding * length * reach;
  for (Eigen::Index k = 0; k < 3; ++k)
    if (std::abs(out.distances[k]) <= least) out.distances[k] = 0;
  out.flat = length <= rounding * out.size * out.size || out.distances.isZero(0);
  out.apart = out.distances.minCoeff() > 0 || out.distances.maxCoeff() < 0;
  return out;
}

bool inside(const Triangle& t, const Plane& p, const Vec3& x) {
  const double least = -rounding * p.normal.norm() * p.size * p.size;
  for (std::size_t k = 0; k < 3; ++k)
    if ((t[(k + 1) % 3] - t[k]).cross(x - t[k]).dot(p.normal) < least) return false;
  return true;
}

void pierce(const Triangle& edges, const Triangle& face, const Plane& p, bool of_a, TriangleCrossing& out) {
  for (std::uint8_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1u) % 3;
    const double from = p.distances[k], to = p.distances[static_cast<Eigen::Index>(next)];
    if (from == to || (from > 0 && to > 0) || (from < 0 && to < 0)) continue;
    const double along = from / (from - to);
    const Vec3 point = edges[k] + along * (edges[next] - edges[k]);
    if (out.count < out.piercings.size() && inside(face, p, point))
      out.piercings[out.count++] = {of_a, k, along, point};
  }
}

}  // namespace

TriangleCrossing crossing(const Triangle& a, const Triangle& b) {
  TriangleCrossing out;
  const Plane of_b = plane(b, a);
  if (of_b.apart && !of_b.flat) return out;
  const Plane of_a = plane(a, b);
  if (of_a.apart && !of_a.flat) return out;
  if (of_a.flat || of_b.flat) {
    const double size = std::max(of_a.size, of_b.size);
    const auto shifted = [&](const Triangle& t) { return Triangle{t[0] - a[0], t[1] - a[0], t[2] - a[0]}; };
    out.crosses = closest(shifted(a), shifted(b)).squared_distance <= rounding * rounding * size * size;
  }
  pierce(a, b, of_b, true, out);
  pierce(b, a, of_a, false, out);
  out.crosses = out.crosses || out.count > 0;
  return out;
}

}  // namespace prosector::collision
