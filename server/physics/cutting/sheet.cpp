#include "server/physics/cutting/sheet.h"

#include <algorithm>
#include <cmath>

#include "server/physics/collision/closest_points.h"

namespace prosector {

Sheet::Sheet(std::span<const Vec3> from, std::span<const Vec3> to) {
  for (std::size_t i = 0; i + 1 < from.size(); ++i) {
    add(from[i], from[i + 1], to[i]);
    add(to[i + 1], to[i], from[i + 1]);
  }
}

void Sheet::add(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 area = (b - a).cross(c - a);
  const double longest = std::max({(b - a).squaredNorm(), (c - a).squaredNorm(), (c - b).squaredNorm()});
  const double rounding = 1e-12 * longest;  // below, the normal is noise
  if (!(area.norm() > rounding)) return;
  pieces_.push_back({{a, b, c}, area.normalized(), a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)});
}

std::optional<Sheet::Crossing> Sheet::crossing(const Vec3& a, const Vec3& b) const {
  constexpr double slack = 1e-9;  // of a piece: no gap between two that share an edge
  std::optional<Crossing> first;
  const Vec3 low = a.cwiseMin(b), high = a.cwiseMax(b);
  for (const Piece& p : pieces_) {
    if ((p.low.array() > high.array()).any() || (p.high.array() < low.array()).any()) continue;
    const double da = p.normal.dot(a - p.corner[0]), db = p.normal.dot(b - p.corner[0]);
    if (da * db > 0 || da == db) continue;
    const double t = da / (da - db);
    if (first && t >= first->t) continue;
    const Vec3 x = a + (b - a) * t;
    const Vec3 e = p.corner[1] - p.corner[0], f = p.corner[2] - p.corner[0], d = x - p.corner[0];
    const double twice = p.normal.dot(e.cross(f));
    const double v = p.normal.dot(d.cross(f)) / twice, w = p.normal.dot(e.cross(d)) / twice;
    if (v < -slack || w < -slack || v + w > 1 + slack) continue;
    first = Crossing{t, p.normal};
  }
  return first;
}

std::optional<Sheet::Foot> Sheet::foot(const Vec3& x, double reach) const {
  std::optional<Foot> best;
  for (const Piece& p : pieces_) {
    if (((p.low - x).array() > reach).any() || ((x - p.high).array() > reach).any()) continue;
    if (std::abs(p.normal.dot(x - p.corner[0])) > reach) continue;
    const Vec3 w = closest_weights(x, p.corner[0], p.corner[1], p.corner[2]);
    const Vec3 point = w[0] * p.corner[0] + w[1] * p.corner[1] + w[2] * p.corner[2];
    const double distance = (point - x).norm();
    if (distance > reach || (best && best->distance <= distance)) continue;
    // Beyond the rim the nearest point isn't below x: the plane's is.
    best = Foot{x - p.normal * p.normal.dot(x - p.corner[0]), p.normal, distance};
  }
  return best;
}

}  // namespace prosector
