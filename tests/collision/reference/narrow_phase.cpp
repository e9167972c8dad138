#include "tests/collision/reference/narrow_phase.h"

#include <algorithm>
#include <limits>

namespace prosector {
namespace {

using Pieces = std::span<const collision::CollisionPiece>;

constexpr int most_gjk_steps = 200;

std::vector<collision::Aabb> boxes_of(Pieces pieces) {
  std::vector<collision::Aabb> out;
  for (const collision::CollisionPiece& piece : pieces) out.push_back(collision::box_of(piece));
  return out;
}

/// Calls f(piece of a, piece of b) for those whose boxes come within `reach()`, which may become less,
/// nearest boxes first.
template <class Reach, class F>
void near_pieces(Pieces a, Pieces b, const Reach& reach, const F& f) {
  if (a.size() == 1 && b.size() == 1) {
    f(a.front(), b.front());
    return;
  }
  struct Candidate {
    double squared_distance;
    std::size_t i, j;
  };
  std::vector<Candidate> candidates;
  const std::vector<collision::Aabb> boxes_a = boxes_of(a), boxes_b = boxes_of(b);
  const double most = reach() * reach();
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      if (const double d = boxes_a[i].squared_distance(boxes_b[j]); d <= most)
        candidates.push_back({d, i, j});
  std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& x, const Candidate& y) {
    return x.squared_distance < y.squared_distance;
  });
  for (const Candidate& c : candidates) {
    if (c.squared_distance > reach() * reach()) break;
    f(a[c.i], b[c.j]);
  }
}

/// How long they may go on before the gap can be down to half of the slop; s.
double safe_time(const collision::CollisionPiece& a, const collision::CollisionPiece& b,
                 const collision::Proximity& now, double slop, const Vec3& relative, double spread) {
  // Convex shapes stay apart while the planes between them do; triangles have no such planes.
  const bool planes = !collision::is_mesh(a) && !collision::is_mesh(b);
  const double closing = (planes ? std::max(0.0, -relative.dot(now.normal)) : relative.norm()) + spread;
  return closing > 0 ? (now.gap - slop / 2) / closing : std::numeric_limits<double>::infinity();
}

}  // namespace

std::optional<collision::Proximity> proximity(const CollisionObject& a, const CollisionObject& b,
                                              double margin) {
  std::optional<collision::Proximity> best;
  const auto reach = [&] { return std::max(0.0, best ? std::min(best->gap, margin) : margin); };
  near_pieces(a.pieces(), b.pieces(), reach,
              [&](const collision::CollisionPiece& p, const collision::CollisionPiece& q) {
                const auto found = collision::proximity(p, q, best ? reach() : margin);
                if (found && (!best || found->gap < best->gap)) best = found;
              });
  return best;
}

std::optional<Impact> time_of_impact(const CollisionObject& a, const CollisionObject& b, double h,
                                     double slop) {
  const auto speed_a = a.speed(), speed_b = b.speed();
  const Vec3 relative = speed_a.linear - speed_b.linear;
  const double spread = speed_a.spread + speed_b.spread, fastest = relative.norm() + spread;
  Impact out;
  for (int step = 0; step < most_gjk_steps; ++step) {
    const std::vector<collision::CollisionPiece> of_a = a.pieces_after(out.time),
                                                 of_b = b.pieces_after(out.time);
    double ahead = std::numeric_limits<double>::infinity();
    std::optional<collision::Proximity> nearest;
    // Farther ones can neither meet within the time nor shorten this step.
    const auto reach = [&] { return slop + fastest * std::min(h - out.time, ahead); };
    near_pieces(of_a, of_b, reach,
                [&](const collision::CollisionPiece& p, const collision::CollisionPiece& q) {
                  const auto found = collision::proximity(p, q, reach());
                  if (!found) return;
                  ahead = std::min(ahead, safe_time(p, q, *found, slop, relative, spread));
                  if (!nearest || found->gap < nearest->gap) nearest = found;
                });
    if (!nearest) return std::nullopt;
    out.at = *nearest;
    if (nearest->gap <= slop) return out;
    if (out.time + ahead > h) return std::nullopt;
    out.time += ahead;
  }
  out.converged = false;
  return out;
}

}  // namespace prosector
