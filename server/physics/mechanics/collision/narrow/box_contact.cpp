#include "server/physics/mechanics/collision/narrow/box_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "server/physics/mechanics/collision/narrow/convex_contact.h"
#include "server/physics/mechanics/collision/primitives/closest_points.h"

namespace prosector::collision {
namespace {

// Edges count as parallel below this sine of the angle between them; their cross product is skipped.
constexpr double parallel = 1e-8;
// Relative to the box size: prefers face axes in a tie, since a face gives a larger patch.
constexpr double edge_handicap = 1e-9;

/// One of the 15 separating axes, in the world frame.
struct Axis {
  Vec3 direction = Vec3::UnitY();  // unit, from b to a
  double overlap = std::numeric_limits<double>::infinity();
  int face = -1;  // 0…2: face of a, 3…5: face of b; −1: cross product of the edges …
  Eigen::Index edge_a = 0, edge_b = 0;
};

/// Returns the axis of least overlap; nothing if an axis separates the boxes.
std::optional<Axis> least_overlap(const BoxShape& a, const BoxShape& b) {
  const Mat3 ra = a.pose.q.toRotationMatrix(), rb = b.pose.q.toRotationMatrix();
  const Vec3 d = a.pose.p - b.pose.p;
  Axis best;
  const auto consider = [&](const Vec3& axis, int face, Eigen::Index i, Eigen::Index j, double handicap) {
    const double apart = axis.dot(d);
    const double overlap = a.half.dot((ra.transpose() * axis).cwiseAbs()) +
                           b.half.dot((rb.transpose() * axis).cwiseAbs()) - std::abs(apart);
    if (!(overlap + handicap < best.overlap)) return overlap >= 0;
    best = {apart < 0 ? Vec3(-axis) : axis, overlap, face, i, j};
    return overlap >= 0;
  };
  for (int k = 0; k < 3; ++k)
    if (!consider(ra.col(k), k, 0, 0, 0) || !consider(rb.col(k), 3 + k, 0, 0, 0)) return std::nullopt;
  const double handicap = edge_handicap * (a.half.maxCoeff() + b.half.maxCoeff());
  for (Eigen::Index i = 0; i < 3; ++i)
    for (Eigen::Index j = 0; j < 3; ++j) {
      const Vec3 axis = ra.col(i).cross(rb.col(j));
      const double sine = axis.norm();
      if (sine > parallel && !consider(axis / sine, -1, i, j, handicap)) return std::nullopt;
    }
  return best;
}

/// Returns the corner of the box farthest in a world direction, in the box's frame.
Vec3 farthest(const BoxShape& box, const Vec3& direction) {
  return ((box.pose.q.conjugate() * direction).array() < 0).select(-box.half, box.half);
}

/// Clips the polygon to the half-space sign·x[axis] ≤ limit (Sutherland and Hodgman 1974).
void clip(std::array<Vec3, 8>& polygon, std::size_t& count, Eigen::Index axis, double sign, double limit) {
  std::array<Vec3, 8> out;
  std::size_t kept = 0;
  const auto height = [&](const Vec3& x) { return sign * x[axis] - limit; };
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 &p = polygon[i], &q = polygon[(i + 1) % count];
    const double hp = height(p), hq = height(q);
    if (hp <= 0 && kept < out.size()) out[kept++] = p;
    if ((hp < 0 && hq > 0) || (hp > 0 && hq < 0)) {
      if (kept < out.size()) out[kept++] = p + hp / (hp - hq) * (q - p);
    }
  }
  polygon = out;
  count = kept;
}

/// Computes the contact patch. It is the face of `incident` most opposed to `normal`, which points out of
/// `reference`. The patch is clipped to the face `axis` of `reference` and to the half-space below this face.
void face_patch(const BoxShape& reference, Eigen::Index axis, const BoxShape& incident, const Vec3& normal,
                BoxOverlap& out) {
  const Vec3 in_incident = incident.pose.q.conjugate() * normal;
  Eigen::Index across = 0;
  in_incident.cwiseAbs().maxCoeff(&across);
  const Eigen::Index u = (across + 1) % 3, v = (across + 2) % 3;
  const Pose to_reference = reference.pose.inverse() * incident.pose;
  Vec3 corner;
  corner[across] = in_incident[across] > 0 ? -incident.half[across] : incident.half[across];
  out.count = 0;
  for (const auto& [su, sv] : {std::pair{1., 1.}, {-1., 1.}, {-1., -1.}, {1., -1.}}) {
    corner[u] = su * incident.half[u];
    corner[v] = sv * incident.half[v];
    out.patch[out.count++] = to_reference * corner;
  }
  for (const Eigen::Index side : {(axis + 1) % 3, (axis + 2) % 3})
    for (const double sign : {1., -1.}) clip(out.patch, out.count, side, sign, reference.half[side]);
  const double sign = (reference.pose.q.conjugate() * normal)[axis] > 0 ? 1 : -1;
  clip(out.patch, out.count, axis, sign, reference.half[axis]);
  for (std::size_t i = 0; i < out.count; ++i) out.patch[i] = reference.pose * out.patch[i];
  if (out.count == 0) {  // nothing left after rounding
    out.patch[0] = incident.pose * farthest(incident, -normal);
    out.count = 1;
  }
}

void edge_patch(const BoxShape& a, const BoxShape& b, const Axis& axis, BoxOverlap& out) {
  const auto edge = [](const BoxShape& box, const Vec3& direction, Eigen::Index along) {
    Vec3 from = farthest(box, direction), to = from;
    from[along] = -box.half[along];
    to[along] = box.half[along];
    return std::pair{box.pose * from, box.pose * to};
  };
  const auto [p, p1] = edge(a, -axis.direction, axis.edge_a);
  const auto [q, q1] = edge(b, axis.direction, axis.edge_b);
  const auto [s, t] = closest_parameters(p, p1 - p, q, q1 - q);
  out.patch[0] = (p + s * (p1 - p) + q + t * (q1 - q)) / 2;
  out.count = 1;
}

std::optional<Proximity> between(const Vec3& a, double radius_a, const Vec3& b, double radius_b,
                                 double margin) {
  const Vec3 d = a - b;
  const double distance = d.norm();
  if (!(distance - radius_a - radius_b <= margin)) return std::nullopt;
  Proximity out;
  if (distance > 0) out.normal = d / distance;
  out.gap = distance;
  out.on_a = a;
  out.on_b = b;
  return rounded(out, radius_a, radius_b);
}

}  // namespace

std::optional<BoxOverlap> box_overlap(const BoxShape& a, const BoxShape& b) {
  const std::optional<Axis> axis = least_overlap(a, b);
  if (!axis) return std::nullopt;
  BoxOverlap out;
  if (axis->face < 0)
    edge_patch(a, b, *axis, out);
  else if (axis->face < 3)
    face_patch(a, axis->face, b, -axis->direction, out);
  else
    face_patch(b, axis->face - 3, a, axis->direction, out);
  Vec3 middle = Vec3::Zero();
  for (std::size_t i = 0; i < out.count; ++i) middle += out.patch[i] / static_cast<double>(out.count);
  Proximity& p = out.proximity;
  p.normal = axis->direction;
  p.gap = -axis->overlap;
  // The patch lies on the incident box: on b if the reference face is a's, on a if it is b's.
  const double shift = axis->face < 0 ? 0.5 : axis->face < 3 ? 1 : 0;
  p.on_a = middle + shift * p.gap * p.normal;
  p.on_b = p.on_a - p.gap * p.normal;
  return out;
}

std::optional<Proximity> box_proximity(const BoxShape& a, const BoxShape& b, double margin) {
  if (const auto overlap = box_overlap(a, b)) return overlap->proximity;
  return convex_proximity(ConvexBox(a.half), a.pose, ConvexBox(b.half), b.pose, margin);
}

std::optional<Proximity> sphere_proximity(const SphereShape& a, const SphereShape& b, double margin) {
  return between(a.center, a.radius, b.center, b.radius, margin);
}

std::optional<Proximity> sphere_box_proximity(const SphereShape& a, const BoxShape& b, double margin) {
  const Vec3 center = b.pose.inverse() * a.center;
  const Vec3 on_box = center.cwiseMax(-b.half).cwiseMin(b.half);
  if (on_box != center) return between(a.center, a.radius, b.pose * on_box, 0, margin);
  if (!center.allFinite()) return std::nullopt;
  Eigen::Index axis = 0;
  const double depth = (b.half - center.cwiseAbs()).minCoeff(&axis);
  Proximity out;
  out.normal = b.pose.q * Vec3((center[axis] < 0 ? -1 : 1) * Vec3::Unit(axis));
  out.gap = -depth;
  out.on_a = a.center;
  out.on_b = a.center + depth * out.normal;
  return rounded(out, a.radius, 0);
}

}  // namespace prosector::collision
