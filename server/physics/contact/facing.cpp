#include "server/physics/contact/facing.h"

namespace prosector {
namespace {

constexpr double same = 0.5;    // cosine: the nearest way out is still the one known
constexpr double deeper = 1.5;  // times the last tick's depth: since then only turns and curves can add
constexpr double least_facing_of_edge = 0.1;  // cosine: the tissue's surface faces the thing
constexpr double inside = 1e-9;               // m
constexpr double outside = 1e-7;              // m
constexpr int most_steps = 24;

/// Returns the surface that lies from a point inside the thing along a direction, at most so far. Marches by
/// the distance, which is never more than the way (Hart 1996, sphere tracing).
std::optional<Distance> way_out(const Collider& collider, const Vec3& from, const Vec3& direction,
                                double most) {
  double way = 0;
  for (int step = 0; step < most_steps; ++step) {
    const Distance d = distance_to(collider, from + way * direction, 0);
    if (d.value > -outside) {
      const Vec3 normal = d.normal.dot(direction) > same ? d.normal : direction;
      return Distance{-way * normal.dot(direction), normal};
    }
    way -= d.value;
    if (way > most) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Distance> side_of(const Collider& collider, const Approach& vertex) {
  const Distance& nearest = vertex.nearest;
  if (vertex.before) {
    if (nearest.normal.dot(*vertex.before) > same) return nearest;
    if (nearest.value < 0)
      return way_out(collider, vertex.at, *vertex.before, deeper * vertex.depth + vertex.lip)
          .value_or(nearest);
    // It has slipped off an edge, to the side: what it makes of that is no older than this tick.
  }
  if (vertex.outward.isZero(0) || -nearest.normal.dot(vertex.outward) > least_facing_of_edge) return nearest;
  const Vec3 from =
      nearest.value >= 0 ? Vec3(vertex.at - (nearest.value + inside) * nearest.normal) : vertex.at;
  const auto back = way_out(collider, from, -vertex.outward, vertex.lip);
  if (!back) return nearest;
  if (nearest.value >= 0) return std::nullopt;
  return back;
}

}  // namespace prosector
