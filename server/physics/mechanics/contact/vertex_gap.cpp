#include "server/physics/mechanics/contact/vertex_gap.h"
#include "common/commands.h"

namespace prosector::contact {
namespace {

constexpr double same = 0.5;  // cosine: the nearest normal still counts as the known one
// Factor on the last tick's depth; within one tick only rotation and curvature can exceed it.
constexpr double deeper = 1.5;
// Cosine between the tissue's inward normal and the collider's normal.
constexpr double least_facing_of_edge = 0.1;
constexpr double inside = 1e-9;   // m
constexpr double outside = 1e-7;  // m
constexpr int most_steps = 24;

/// Finds the collider's surface from a point inside along a direction, at most `most` (m) away. Marches by
/// the distance, which never exceeds the remaining path (Hart 1996, sphere tracing).
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
    // The vertex slipped off an edge to the side: its history before this tick does not apply.
  }
  if (vertex.outward.isZero(0) || -nearest.normal.dot(vertex.outward) > least_facing_of_edge) return nearest;
  const Vec3 from =
      nearest.value >= 0 ? Vec3(vertex.at - (nearest.value + inside) * nearest.normal) : vertex.at;
  const auto back = way_out(collider, from, -vertex.outward, vertex.lip);
  if (!back) return nearest;
  if (nearest.value >= 0) return std::nullopt;
  return back;
}

}  // namespace prosector::contact
