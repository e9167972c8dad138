// Phase 3, for what is fast: where a rigid and a soft body would pass through each other within the tick.

#include <algorithm>
#include <limits>

#include "server/physics/simulation_impl.h"

namespace prosector {
namespace {

constexpr double least_way =
    0.002;  // m: between two looks; thin things are looked for twice within their thickness
constexpr int most_looks = 1000;

/// Half the thinnest extent of the collider's parts.
double thinnest(const Collider& collider) {
  double least = std::numeric_limits<double>::max();
  for (const ShapePart& part : *collider.parts) least = std::min(least, part_extent(part).half.minCoeff());
  return least;
}

/// The collider after t seconds, seen by something that moves at `drift` (m/s).
Collider after(const Collider& collider, double t, const Vec3& drift) {
  Collider out = collider;
  const Vec3 turn = t * collider.angular;
  if (turn.norm() > 0) out.pose.q = Quat(Eigen::AngleAxisd(turn.norm(), turn.normalized())) * collider.pose.q;
  out.pose.p += t * (collider.linear - drift);
  return out;
}

}  // namespace

bool Simulation::Impl::is_swept(std::size_t body, const Collider& collider) const {
  if (is_room(collider.slot)) return false;  // nothing is on its other side
  const bool wanted = model.soft_collision[body].continuous ||
                      (!hand_at(collider.slot) && model.rigid[collider.slot].setup.continuous);
  return wanted &&
         step_h * (total_speed(collider) + soft[body].motion.v.lpNorm<Eigen::Infinity>()) > contact_margin;
}

bool Simulation::Impl::add_swept_contacts(std::size_t body, const Collider& collider, double margin,
                                          std::vector<Contact>& out) const {
  const double at_once = contact_margin + inner_reach_of(body);
  if (touches(body, collider, at_once)) return add_contacts(body, collider, margin, memories[body], out);
  const Vec3 drift = soft[body].motion.v.reshaped(3, model.soft[body]->nodes()).rowwise().mean();
  const double half_diagonal = (collider.hi - collider.lo).norm() / 2;
  const double way = step_h * ((collider.linear - drift).norm() + collider.angular.norm() * half_diagonal);
  const int looks =
      std::clamp(static_cast<int>(std::ceil(way / std::max(least_way, thinnest(collider)))), 1, most_looks);
  for (int k = 1; k <= looks; ++k) {
    const double t = step_h * k / looks;
    Collider then = after(collider, t, drift);
    // A box that holds however it has turned.
    const Vec3 middle = (collider.lo + collider.hi) / 2 + then.pose.p - collider.pose.p;
    const Vec3 half = Vec3::Constant(half_diagonal + (middle - then.pose.p).norm());
    then.lo = then.pose.p - half;
    then.hi = then.pose.p + half;
    const std::size_t first = out.size();
    if (!add_contacts(body, then, at_once, memories[body], out)) continue;
    const Pose back = collider.pose * then.pose.inverse();
    for (std::size_t c = first; c < out.size(); ++c) {
      Contact& contact = out[c];
      const Vec3 at_start = back * contact.point;
      // Linear in what both sides move from now on, with that gap at that time.
      contact.gap += contact.normal.dot(contact.point - at_start);
      if (contact.b.kind == ContactSide::Kind::rigid) contact.b.arm = at_start - collider.pose.p;
      contact.b.moved = driven_way(collider, at_start);
    }
    return true;
  }
  return false;
}

}  // namespace prosector
