#include "client/haptics/plane_set.h"

#include <algorithm>

namespace prosector {
namespace {

constexpr double least_spread = 0.005, most_spread = 0.05;  // s

}  // namespace

void PlaneSet::take(std::span<const ContactPlane> planes, double time) {
  news_.note(time);
  signs_.note(time);
  const double spread = std::clamp(news_.interval(), least_spread, most_spread);
  for (PlaneContact& contact : contacts_)
    if (std::none_of(planes.begin(), planes.end(), [&](const auto& p) { return p.id == contact.id(); }))
      contact.end(spread);
  for (const ContactPlane& plane : planes) {
    const auto known = std::find_if(contacts_.begin(), contacts_.end(),
                                    [&](const PlaneContact& c) { return c.id() == plane.id; });
    if (known == contacts_.end())
      contacts_.emplace_back(plane, spread);
    else
      known->renew(plane, spread);
  }
}

PlaneForce PlaneSet::advance(const Pose& hand, const Vec3& velocity, double dt) {
  PlaneForce sum;
  double weight = 0;
  for (PlaneContact& contact : contacts_) {
    const PlaneForce one = contact.advance(hand, velocity, dt);
    sum.force += one.force;
    sum.stiffness += one.stiffness;
    sum.stored += one.stored;
    sum.power += one.power;
    sum.point += one.force.norm() * one.point;
    weight += one.force.norm();
  }
  if (weight > 0) sum.point /= weight;
  std::erase_if(contacts_, [](const PlaneContact& c) { return c.gone(); });
  return sum;
}

}  // namespace prosector
