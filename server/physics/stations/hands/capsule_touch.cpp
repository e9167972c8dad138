#include "server/physics/stations/hands/capsule_touch.h"

#include <algorithm>

namespace prosector {
namespace {

constexpr int projections = 4;     // alternating projections from a place near the nearest point
constexpr int from_ends = 16;      // the same, from the ends of a capsule
constexpr double line_gap = 2e-4;  // m: difference of gaps within which a capsule touches along a line

double project(const Capsule& capsule, const Pose& pose, const Vec3& x) {
  return std::clamp((pose.inverse() * x).y(), -capsule.length / 2, capsule.length / 2);
}

double search(const Capsule& capsule, const Pose& pose, const contact::Collider& body, double along,
              double margin, int times) {
  for (int i = 0; i < times; ++i)
    along = project(capsule, pose, touch_of(capsule, pose, body, along, margin).point_b);
  return along;
}

}  // namespace

rigid::RigidContact touch_of(const Capsule& capsule, const Pose& pose, const contact::Collider& body,
                             double along, double margin) {
  const Vec3 at = pose * Vec3(0, along, 0);
  const contact::Distance d = contact::distance_to(body, at, margin + capsule.radius);
  rigid::RigidContact out{};
  out.point_a = at - capsule.radius * d.normal;
  out.point_b = at - d.value * d.normal;
  out.normal = d.normal;
  out.gap = d.value - capsule.radius;
  return out;
}

double nearest_along(const Capsule& capsule, const Pose& pose, const contact::Collider& body, double from,
                     double margin) {
  return search(capsule, pose, body, from, margin, projections);
}

double middle_along(const Capsule& capsule, const Pose& pose, const contact::Collider& body,
                    const Vec3& place, double margin) {
  const double end = capsule.length / 2;
  const auto gap = [&](double along) { return touch_of(capsule, pose, body, along, margin).gap; };
  const double nearest = nearest_along(capsule, pose, body, project(capsule, pose, place), margin),
               low = search(capsule, pose, body, -end, margin, from_ends),
               high = search(capsule, pose, body, end, margin, from_ends);
  const double below = gap(low), above = gap(high);
  if (std::max(below, above) > gap(nearest) + line_gap) return nearest;
  const double share = std::clamp(0.5 + (below - above) / (2 * line_gap), 0.0, 1.0);
  return low + share * (high - low);
}

}  // namespace prosector
