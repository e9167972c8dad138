#include "client/haptics/plane_set.h"

#include <Eigen/Eigenvalues>

#include <algorithm>

namespace prosector {
namespace {

constexpr double least_spread = 0.005, most_spread = 0.05;  // s

/// Returns the cross-product matrix of `v`.
Mat3 cross_product_matrix(const Vec3& v) {
  return (Mat3() << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0).finished();
}

}  // namespace

void PlaneSet::take(std::span<const ContactPlane> planes, double time) {
  update_rate_.note(time);
  message_rate_.note(time);
  const double spread = std::clamp(update_rate_.interval(), least_spread, most_spread);
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

FeltWrench PlaneSet::advance(const Pose& hand, const HandMotion& motion, const Vec3& pivot, double dt) {
  FeltWrench sum;
  Mat3 turning = Mat3::Zero();
  for (PlaneContact& contact : contacts_) {
    const PlaneForce one = contact.advance(hand, motion, dt);
    const Vec3 lever = one.point - pivot;
    sum.wrench.force += one.force;
    sum.wrench.torque += lever.cross(one.force);
    sum.stiffness += one.stiffness;
    turning += cross_product_matrix(lever) * one.stiffness * cross_product_matrix(lever).transpose();
    sum.stored += one.stored;
    sum.power += one.power;
  }
  sum.torsion = turning.selfadjointView<Eigen::Lower>().operatorNorm();
  std::erase_if(contacts_, [](const PlaneContact& c) { return c.gone(); });
  return sum;
}

}  // namespace prosector
