#include "server/physics/mechanics/cutting/swept_surface.h"

#include <algorithm>
#include <cmath>

#include "common/assert.h"
#include "server/physics/mechanics/collision/primitives/closest_points.h"

namespace prosector::cutting {

namespace {

constexpr double smooth = 0.7;  // cosine of the angle up to which a piece keeps its own normal
// Relative to the longer of two motions: ends whose motions differ by less count as moving in parallel.
constexpr double least_twist = 0.05;
constexpr double most_strips = 40;

Vec3 twice_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b - a).cross(c - a);
}

double strips_of(const Vec3& motion, const Vec3& next_motion) {
  const double longest = std::max(motion.norm(), next_motion.norm());
  const double twist = (next_motion - motion).norm();
  return twist > least_twist * longest ? std::min(most_strips, std::ceil(twist / (least_twist * longest)))
                                       : 1;
}

}  // namespace

SweptSurface::SweptSurface(std::span<const Vec3> from, std::span<const Vec3> to,
                           std::span<const std::size_t> part, Twist twist) {
  PROSECTOR_ASSERT(from.size() >= 2 && to.size() == from.size() && part.size() == from.size());
  for (std::size_t first = 0, next = 0; first + 1 < from.size(); first = next) {
    Vec3 area = Vec3::Zero();
    for (next = first; next + 1 < from.size() && part[next] == part[first]; ++next)
      area += twice_area(from[next], from[next + 1], to[next]) +
              twice_area(to[next + 1], to[next], from[next + 1]);
    for (std::size_t i = first; i < next; ++i) {
      const Vec3 along = from[i + 1] - from[i], along_to = to[i + 1] - to[i];
      const double strips =
          twist == Twist::followed ? strips_of(to[i] - from[i], to[i + 1] - from[i + 1]) : 1;
      Vec3 a = from[i], b = to[i];
      for (double strip = 1; strip <= strips; ++strip) {
        const bool is_last = strip == strips;
        const Vec3 next_a = is_last ? from[i + 1] : Vec3(from[i] + strip / strips * along);
        const Vec3 next_b = is_last ? to[i + 1] : Vec3(to[i] + strip / strips * along_to);
        add(a, next_a, b, area);
        add(next_b, b, next_a, area);
        a = next_a;
        b = next_b;
      }
    }
  }
}

void SweptSurface::add(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& part_area) {
  const Vec3 area = twice_area(a, b, c);
  const double longest = std::max({(b - a).squaredNorm(), (c - a).squaredNorm(), (c - b).squaredNorm()});
  const double rounding = 1e-12 * longest;  // with less area, the normal is noise
  if (!(area.norm() > rounding)) return;
  const Vec3 normal = area.normalized();
  const bool is_smooth = normal.dot(part_area) >= smooth * part_area.norm();
  pieces_.push_back({{a, b, c},
                     normal,
                     is_smooth ? normal : part_area.normalized(),
                     a.cwiseMin(b).cwiseMin(c),
                     a.cwiseMax(b).cwiseMax(c)});
}

std::optional<SweptSurface::Crossing> SweptSurface::crossing(const Vec3& a, const Vec3& b) const {
  constexpr double slack = 1e-9;  // relative to a piece: no gap between pieces with a common edge
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
    first = Crossing{t, p.up};
  }
  return first;
}

std::optional<SweptSurface::Foot> SweptSurface::foot(const Vec3& x, double reach) const {
  std::optional<Foot> best;
  for (const Piece& p : pieces_) {
    if (((p.low - x).array() > reach).any() || ((x - p.high).array() > reach).any()) continue;
    if (std::abs(p.normal.dot(x - p.corner[0])) > reach) continue;
    const Vec3 w = collision::closest_weights(x, p.corner[0], p.corner[1], p.corner[2]);
    const Vec3 point = w[0] * p.corner[0] + w[1] * p.corner[1] + w[2] * p.corner[2];
    const double distance = (point - x).norm();
    if (distance > reach || (best && best->distance <= distance)) continue;
    // Outside the rim, uses the projection of x onto the piece's plane instead of the nearest point.
    best = Foot{x - p.up * p.up.dot(x - point), p.up, distance};
  }
  return best;
}

}  // namespace prosector::cutting
