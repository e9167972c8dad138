#include "server/physics/stations/touching/swept_contacts.h"

#include <algorithm>
#include <limits>

#include "common/rotation.h"
#include "server/physics/mechanics/contact/margins.h"
#include "server/physics/stations/touching/colliders.h"
#include "server/physics/stations/touching/rigid_soft_contacts.h"

namespace prosector {
namespace {

// m: distance between two tests; thin parts are tested twice within their thickness.
constexpr double least_way = 0.002;
constexpr int most_looks = 1000;

/// Returns half of the smallest extent of the collider's parts.
double thinnest(const contact::Collider& collider) {
  double least = std::numeric_limits<double>::max();
  for (const collision::ShapePart& part : *collider.parts)
    least = std::min(least, collision::part_extent(part).half.minCoeff());
  return least;
}

/// Returns the collider after t s, relative to a body that moves at `drift` (m/s).
contact::Collider after(const contact::Collider& collider, double t, const Vec3& drift) {
  contact::Collider out = collider;
  out.pose.q = rotated_by(t * collider.angular) * collider.pose.q;
  out.pose.p += t * (collider.linear - drift);
  return out;
}

}  // namespace

bool is_swept(const Tissue& tissue, const contact::Collider& collider, double h) {
  if (rigid::is_room(collider.slot)) return false;  // nothing is behind a side of the room
  return (tissue.collision.continuous || collider.continuous) &&
         h * (total_speed(collider) + tissue.state.motion.v.lpNorm<Eigen::Infinity>()) >
             contact::contact_margin;
}

bool add_swept_contacts(const Tissue& tissue, const contact::Collider& collider, double margin, double h,
                        std::vector<contact::Contact>& out) {
  const double at_once = contact::contact_margin + tissue.inner_reach(h);
  if (touches(tissue, collider, at_once))
    return add_contacts(tissue, collider, margin, tissue.memories, h, out);
  const Vec3 drift = tissue.state.motion.v.reshaped(3, tissue.solver->nodes()).rowwise().mean();
  const double half_diagonal = (collider.hi - collider.lo).norm() / 2;
  const double way = h * ((collider.linear - drift).norm() + collider.angular.norm() * half_diagonal);
  const int looks =
      std::clamp(static_cast<int>(std::ceil(way / std::max(least_way, thinnest(collider)))), 1, most_looks);
  for (int k = 1; k <= looks; ++k) {
    const double t = h * k / looks;
    contact::Collider then = after(collider, t, drift);
    // A box that encloses the collider for any rotation.
    const Vec3 middle = (collider.lo + collider.hi) / 2 + then.pose.p - collider.pose.p;
    const Vec3 half = Vec3::Constant(half_diagonal + (middle - then.pose.p).norm());
    then.lo = then.pose.p - half;
    then.hi = then.pose.p + half;
    const std::size_t first = out.size();
    if (!add_contacts(tissue, then, at_once, tissue.memories, h, out)) continue;
    const Pose back = collider.pose * then.pose.inverse();
    for (std::size_t c = first; c < out.size(); ++c) {
      contact::Contact& contact = out[c];
      const Vec3 at_start = back * contact.point;
      // Linear in the further motion of both sides, with that gap at that time.
      contact.gap += contact.normal.dot(contact.point - at_start);
      if (contact.b.kind == contact::ContactSide::Kind::rigid) contact.b.arm = at_start - collider.pose.p;
      contact.b.moved = kinematic_way(collider, at_start);
    }
    return true;
  }
  return false;
}

}  // namespace prosector
