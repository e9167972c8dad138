#include "twins/arms/arm_model.h"

#include <algorithm>
#include <cmath>

namespace prosector {
namespace {

constexpr double longest_step = 1e-4;  // s

}  // namespace

void ArmModel::set_force(const Vec3& force) {
  if (!force.allFinite()) {
    force_.setZero();
    return;
  }
  const double size = force.norm();
  force_ = size > mechanics_.peak_force ? Vec3(force * (mechanics_.peak_force / size)) : force;
}

void ArmModel::advance(double dt, const Vec3& intended, const Vec3& velocity) {
  const int steps = std::max(1, static_cast<int>(std::ceil(dt / longest_step - 1e-9)));
  const double h = dt / steps, mass = mechanics_.mass + hand_.mass;
  // Hand and damping are integrated implicitly, so that a stiff hand stays stable; friction is then applied.
  const double resists = mass + h * (mechanics_.damping + hand_.damping) + h * h * hand_.stiffness;
  for (int k = 0; k < steps; ++k) {
    const Vec3 target = intended - velocity * ((steps - 1 - k) * h);
    const Vec3 pull = force_ + hand_.stiffness * (target - position_) + hand_.damping * velocity;
    Vec3 v = (mass * velocity_ + h * pull) / resists;
    const double speed = v.norm(), stopped = h * mechanics_.friction / resists;
    v *= speed > stopped ? 1 - stopped / speed : 0;
    velocity_ = v;
    position_ += h * v;
    energy_ -= h * force_.dot(v);
  }
}

Vec3 ArmModel::measured() const {
  const double q = mechanics_.quantum;
  return q > 0 ? Vec3((position_ / q).array().round().matrix() * q) : position_;
}

}  // namespace prosector
