#include "server/physics/mechanics/rigid/triangulate.h"

#include <algorithm>
#include <limits>

namespace prosector::rigid {
namespace {

using Loop = std::vector<std::uint32_t>;

double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

class Polygon {
 public:
  explicit Polygon(std::span<const Vec2> points) : points_(points) {}

  /// Returns twice the signed area of a triangle; > 0: counter-clockwise.
  double turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return cross(points_[b] - points_[a], points_[c] - points_[a]);
  }
  double area(const Loop& loop) const {
    double sum = 0;
    for (std::size_t i = 0; i < loop.size(); ++i)
      sum += cross(points_[loop[i]], points_[loop[(i + 1) % loop.size()]]);
    return sum;
  }
  bool around(const Loop& loop, std::uint32_t p) const {
    bool inside = false;
    const Vec2& x = points_[p];
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2 &a = points_[loop[i]], &b = points_[loop[(i + 1) % loop.size()]];
      if ((a.y() > x.y()) == (b.y() > x.y())) continue;
      if (x.x() < a.x() + (x.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
    }
    return inside;
  }
  bool crosses(const Loop& loop, std::uint32_t p, std::uint32_t q) const {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::uint32_t a = loop[i], b = loop[(i + 1) % loop.size()];
      if (a == p || a == q || b == p || b == q) continue;
      if (turn(p, q, a) * turn(p, q, b) <= 0 && turn(a, b, p) * turn(a, b, q) <= 0) return true;
    }
    return false;
  }
  /// Returns the outer loop and the hole as one loop, connected by a bridge in both directions.
  Loop joined(const Loop& outer, const Loop& hole) const {
    double shortest = std::numeric_limits<double>::max();
    std::size_t from = 0, to = 0;
    for (std::size_t i = 0; i < outer.size(); ++i)
      for (std::size_t j = 0; j < hole.size(); ++j) {
        const double d = (points_[outer[i]] - points_[hole[j]]).squaredNorm();
        if (d >= shortest || crosses(outer, outer[i], hole[j]) || crosses(hole, outer[i], hole[j])) continue;
        shortest = d;
        from = i;
        to = j;
      }
    Loop out(outer.begin(), outer.begin() + static_cast<std::ptrdiff_t>(from) + 1);
    for (std::size_t j = 0; j <= hole.size(); ++j) out.push_back(hole[(to + j) % hole.size()]);
    out.insert(out.end(), outer.begin() + static_cast<std::ptrdiff_t>(from), outer.end());
    return out;
  }
  /// Returns whether the corner at i is convex and its triangle contains no other point of the loop.
  bool is_ear(const Loop& loop, std::size_t i) const {
    const std::size_t n = loop.size();
    const std::uint32_t a = loop[(i + n - 1) % n], b = loop[i], c = loop[(i + 1) % n];
    if (turn(a, b, c) <= 0) return false;
    return std::none_of(loop.begin(), loop.end(), [&](std::uint32_t p) {
      if (p == a || p == b || p == c) return false;
      const Vec2& x = points_[p];
      if (x == points_[a] || x == points_[b] || x == points_[c]) return false;
      return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
    });
  }
  /// Returns the next ear. If rounding leaves no ear, returns the corner with the largest area, so that the
  /// boundary is unchanged.
  std::size_t next_ear(const Loop& loop) const {
    for (std::size_t i = 0; i < loop.size(); ++i)
      if (is_ear(loop, i)) return i;
    std::size_t best = 0;
    double most = -std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::size_t n = loop.size();
      const double t = turn(loop[(i + n - 1) % n], loop[i], loop[(i + 1) % n]);
      if (t > most) most = t, best = i;
    }
    return best;
  }

 private:
  std::span<const Vec2> points_;
};

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Vec2> points,
                                                      const std::vector<Loop>& loops) {
  const Polygon polygon(points);
  std::vector<Loop> outer, holes;
  for (const Loop& loop : loops) (polygon.area(loop) < 0 ? holes : outer).push_back(loop);
  const std::vector<Loop> whole = outer;
  for (const Loop& hole : holes) {
    // The smallest loop around the hole. A hole outside all loops is triangulated alone, with opposite
    // orientation.
    std::size_t best = whole.size();
    for (std::size_t i = 0; i < whole.size(); ++i)
      if (polygon.around(whole[i], hole.front()) &&
          (best == whole.size() || polygon.area(whole[i]) < polygon.area(whole[best])))
        best = i;
    if (best < whole.size())
      outer[best] = polygon.joined(outer[best], hole);
    else
      outer.push_back(hole);
  }
  std::vector<std::array<std::uint32_t, 3>> out;
  for (Loop& loop : outer)
    while (loop.size() >= 3) {
      const std::size_t i = polygon.next_ear(loop), n = loop.size();
      out.push_back({loop[(i + n - 1) % n], loop[i], loop[(i + 1) % n]});
      loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(i));
    }
  return out;
}

}  // namespace prosector::rigid
