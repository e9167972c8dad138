#include "client/haptics/plane_set.h"

#include <algorithm>
#include <cmath>

namespace prosector {
namespace {

constexpr double memory = 0.1;                              // weight of the newest interval
constexpr double least_wait = 0.03, most_wait = 0.25;       // s without a message, until none is expected
constexpr double least_spread = 0.005, most_spread = 0.05;  // s
constexpr double longest_interval = 0.2;  // s: a longer one is a pause, and tells of no rate

}  // namespace

void PlaneSet::take(std::span<const ContactPlane> planes, const Pose& hand, double time) {
  if (last_ >= 0 && time - last_ < longest_interval) {
    const double off = time - last_ - interval_;
    interval_ += memory * off;
    jitter_ += memory * (std::abs(off) - jitter_);
  }
  last_ = time;
  const double spread = std::clamp(interval_, least_spread, most_spread);
  for (PlaneContact& contact : contacts_)
    if (std::none_of(planes.begin(), planes.end(), [&](const auto& p) { return p.id == contact.id(); }))
      contact.end(hand, spread);
  for (const ContactPlane& plane : planes) {
    const auto known = std::find_if(contacts_.begin(), contacts_.end(),
                                    [&](const PlaneContact& c) { return c.id() == plane.id; });
    if (known == contacts_.end())
      contacts_.emplace_back(plane, hand, spread);
    else
      known->renew(plane, hand, spread);
  }
}

PlaneForce PlaneSet::advance(const Pose& hand, const Vec3& velocity, double dt) {
  PlaneForce sum;
  double weight = 0;
  for (PlaneContact& contact : contacts_) {
    const PlaneForce one = contact.advance(hand, velocity, dt);
    sum.force += one.force;
    sum.stored += one.stored;
    sum.power += one.power;
    sum.point += one.force.norm() * one.point;
    weight += one.force.norm();
  }
  if (weight > 0) sum.point /= weight;
  std::erase_if(contacts_, [](const PlaneContact& c) { return c.gone(); });
  return sum;
}

bool PlaneSet::stale(double time) const {
  return last_ < 0 || time - last_ > std::clamp(3 * (interval_ + jitter_), least_wait, most_wait);
}

}  // namespace prosector
