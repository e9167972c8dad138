#include "server/physics/mechanics/coupled/rigid_energy.h"

#include "common/assert.h"
#include "server/physics/mechanics/contact/potentials.h"

namespace prosector::coupled {

double inertia_energy(const RigidMember& body, const Vec6& twist, double h) {
  PROSECTOR_ASSERT(h > 0);
  const Vec6 d = twist - body.predicted;
  return (body.mass * d.head<3>().squaredNorm() + d.tail<3>().dot(body.inertia * d.tail<3>())) / (2 * h * h);
}

void add_energy(const RigidMember& body, const Vec6& twist, double h, double& sum) {
  sum += inertia_energy(body, twist, h);
  if (!body.pull) return;
  const hands::Pull& pull = *body.pull;
  sum += contact::BoundedSpring{pull.stiffness, pull.max_force}.energy(
      (twist.head<3>() - pull.translation).norm());
  sum += contact::BoundedSpring{pull.angular_stiffness, pull.max_moment}.energy(
      (twist.tail<3>() - pull.rotation).norm());
}

void set_gradient(const RigidMember& body, const Vec6& twist, double h, Eigen::Ref<Vec6> out) {
  PROSECTOR_ASSERT(h > 0);
  const Vec6 d = twist - body.predicted;
  out.head<3>() = body.mass / (h * h) * d.head<3>();
  out.tail<3>() = body.inertia * d.tail<3>() / (h * h);
  if (!body.pull) return;
  const hands::Pull& pull = *body.pull;
  const Vec3 e = twist.head<3>() - pull.translation, r = twist.tail<3>() - pull.rotation;
  out.head<3>() += contact::BoundedSpring{pull.stiffness, pull.max_force}.secant(e.norm()) * e;
  out.tail<3>() += contact::BoundedSpring{pull.angular_stiffness, pull.max_moment}.secant(r.norm()) * r;
}

Mat6 hessian_of(const RigidMember& body, const Vec6& twist, double h) {
  PROSECTOR_ASSERT(h > 0);
  Mat6 block = Mat6::Zero();
  block.topLeftCorner<3, 3>() = body.mass / (h * h) * Mat3::Identity();
  block.bottomRightCorner<3, 3>() = body.inertia / (h * h);
  if (!body.pull) return block;
  const hands::Pull& pull = *body.pull;
  const double e = (twist.head<3>() - pull.translation).norm(), r = (twist.tail<3>() - pull.rotation).norm();
  block.diagonal().head<3>().array() += contact::BoundedSpring{pull.stiffness, pull.max_force}.secant(e);
  block.diagonal().tail<3>().array() +=
      contact::BoundedSpring{pull.angular_stiffness, pull.max_moment}.secant(r);
  return block;
}

}  // namespace prosector::coupled
