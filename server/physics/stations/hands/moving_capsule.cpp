#include "server/physics/stations/hands/moving_capsule.h"

#include <algorithm>
#include <cmath>

#include "server/physics/mechanics/contact/margins.h"

namespace prosector {
namespace {

constexpr double touching = 5e-4;       // m: gap at which a capsule on its path touches
constexpr int most_advances = 24;       // along a path; paths that graze a body take many
constexpr double least_advance = 0.01;  // of the path
constexpr double places_apart = 2e-3;   // m: least distance of a capsule's contacts

}  // namespace

Pose HandPath::at(double share) const {
  const double angle = share * rotation.norm();
  const Quat turned(Eigen::AngleAxisd(angle, angle > 0 ? Vec3(rotation.normalized()) : Vec3::UnitX()));
  return {centre.p + share * translation, turned * centre.q};
}

MovingCapsule::MovingCapsule(const Capsule& shape, const Pose& in_hand, const HandPath& path, double known)
    : shape_(shape), in_hand_(in_hand), path_(path), known_(known) {
  measure();
}

void MovingCapsule::measure() {
  length_ = path_.translation.norm() + path_.rotation.norm() * (in_hand_.p.norm() + radius());
}

bool MovingCapsule::is_fast() const {
  return length_ > contact::contact_margin;
}

bool MovingCapsule::may_meet(const contact::Collider& body) const {
  const Vec3 from = path_.centre * in_hand_.p, to = path_.at(1) * in_hand_.p;
  const double off_line = path_.rotation.norm() * (radius() + in_hand_.p.norm() * path_.rotation.norm());
  const Vec3 reach = Vec3::Constant(radius() + off_line + contact::contact_margin);
  return contact::boxes_overlap(from.cwiseMin(to) - reach, from.cwiseMax(to) + reach, body.lo, body.hi);
}

double MovingCapsule::nearest(const Pose& centre, const contact::Collider& body) const {
  return nearest_along(shape_, centre * in_hand_, body, 0, length_ + contact::contact_margin);
}

rigid::RigidContact MovingCapsule::touch_at(const Pose& centre, const contact::Collider& body,
                                            double along) const {
  return touch_of(shape_, centre * in_hand_, body, along, length_ + contact::contact_margin);
}

void MovingCapsule::slide_along(const contact::Collider& body) {
  const rigid::RigidContact touch = touch_at(path_.centre, body, nearest(path_.centre, body));
  if (!(touch.gap < known_)) return;
  path_.translation -= std::min(0.0, touch.normal.dot(path_.translation)) * touch.normal;
  measure();
}

std::optional<double> MovingCapsule::share_until_touch(const contact::Collider& body) const {
  double share = 0;
  for (int k = 0; k < most_advances && share <= 1; ++k) {
    const Pose centre = path_.at(share);
    const double gap = touch_at(centre, body, nearest(centre, body)).gap;
    if ((k == 0 && gap < known_) || gap > (1 - share) * length_ + touching) return std::nullopt;
    if (gap <= touching) return share;
    share += std::max(least_advance, (gap - touching / 2) / length_);
  }
  return std::nullopt;
}

std::vector<rigid::RigidContact> MovingCapsule::first_touch(const contact::Collider& body) const {
  std::vector<rigid::RigidContact> out;
  const std::optional<double> share = share_until_touch(body);
  if (!share) return out;
  const Pose centre = path_.at(*share);
  const double first = nearest(centre, body);
  for (const double along : {first, -shape_.length / 2, shape_.length / 2}) {
    if (along != first && std::abs(along - first) < places_apart) continue;
    rigid::RigidContact touch = touch_at(centre, body, along);
    if (touch.gap > length_) continue;
    const Vec3 before = path_.centre * (centre.inverse() * touch.point_a);
    touch.gap += touch.normal.dot(before - touch.point_a);
    touch.point_a = before;
    out.push_back(touch);
  }
  return out;
}

}  // namespace prosector
