#include "server/physics/mechanics/soft/unfold.h"

#include <Eigen/LU>
#include <cmath>

#include "server/physics/mechanics/soft/laws/polar.h"

namespace prosector::soft {
namespace {

double six_volumes(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return (b - a).cross(c - a).dot(d - a);
}

Vec3 mean(const VecX& values, const VecX& mass) {
  return values.reshaped(3, mass.size()) * mass / mass.sum();
}

}  // namespace

double inverted_share(const TetMesh& mesh, const VecX& x, double least) {
  double crushed = 0, all = 0;
  const auto at = [&](std::uint32_t i) -> Vec3 { return x.segment<3>(3 * static_cast<Eigen::Index>(i)); };
  for (const auto& t : mesh.tets) {
    const auto& X = mesh.positions;
    const double rest = six_volumes(X[t[0]], X[t[1]], X[t[2]], X[t[3]]);
    const double now = six_volumes(at(t[0]), at(t[1]), at(t[2]), at(t[3]));
    all += std::abs(rest);
    if (now * rest <= least * rest * rest) crushed += std::abs(rest);
  }
  return all > 0 ? crushed / all : 0;
}

double volume_share(const TetMesh& mesh, const VecX& x) {
  double then = 0, now = 0;
  const auto at = [&](std::uint32_t i) -> Vec3 { return x.segment<3>(3 * static_cast<Eigen::Index>(i)); };
  for (const auto& t : mesh.tets) {
    const auto& X = mesh.positions;
    const double rest = six_volumes(X[t[0]], X[t[1]], X[t[2]], X[t[3]]);
    then += std::abs(rest);
    now += std::copysign(1, rest) * six_volumes(at(t[0]), at(t[1]), at(t[2]), at(t[3]));
  }
  return then > 0 ? now / then : 1;
}

Mat3 best_rotation(const VecX& rest, const VecX& mass, const VecX& x) {
  const Vec3 from = mean(rest, mass), to = mean(x, mass);
  Mat3 covariance = Mat3::Zero();
  for (Eigen::Index i = 0; i < mass.size(); ++i)
    covariance += mass[i] * (x.segment<3>(3 * i) - to) * (rest.segment<3>(3 * i) - from).transpose();
  return polar(covariance).R;
}

void unfold(const VecX& rest, const VecX& mass, bool turn, SoftBodyState& state) {
  VecX &x = state.motion.x, &v = state.motion.v;
  const Vec3 from = mean(rest, mass), to = mean(x, mass), velocity = mean(v, mass);
  Vec3 spin = Vec3::Zero();  // angular momentum
  for (Eigen::Index i = 0; i < mass.size(); ++i) {
    const Vec3 arm = x.segment<3>(3 * i) - to;
    spin += mass[i] * arm.cross(v.segment<3>(3 * i) - velocity);
  }
  const Mat3 R = turn ? best_rotation(rest, mass, x) : Mat3(Mat3::Identity());
  Mat3 inertia = Mat3::Zero();
  for (Eigen::Index i = 0; i < mass.size(); ++i) {
    const Vec3 arm = R * (rest.segment<3>(3 * i) - from);
    inertia += mass[i] * (arm.squaredNorm() * Mat3::Identity() - arm * arm.transpose());
    x.segment<3>(3 * i) = to + arm;
  }
  const Vec3 omega = turn ? Vec3(inertia.ldlt().solve(spin)) : Vec3(Vec3::Zero());
  for (Eigen::Index i = 0; i < mass.size(); ++i)
    v.segment<3>(3 * i) = velocity + omega.cross(x.segment<3>(3 * i) - to);
  state.motion.has_history = false;
  state.warm_start.setZero();
  state.history.setZero();
  state.recovering = false;
  state.law_seconds = 0;
}

bool rotated_by(const SoftBody& body, double angle, const VecX& x) {
  if (body.objective()) return false;
  return best_rotation(body.rest(), body.node_mass(), x).trace() < 1 + 2 * std::cos(angle);
}

void unfold(const SoftBody& body, SoftBodyState& state) {
  unfold(body.rest(), body.node_mass(), body.objective(), state);
  if (!body.attached()) return;
  state.motion.x = body.rest();
  state.motion.v.setZero();
}

}  // namespace prosector::soft
