#include "twins/arms/wrist_model.h"

#include <algorithm>
#include <cmath>

#include "common/rotation.h"

namespace prosector {
namespace {

constexpr double longest_turning_step = 1e-4;  // s

}  // namespace

void WristModel::set_torque(const Vec3& torque) {
  if (!torque.allFinite()) {
    torque_.setZero();
    return;
  }
  const double size = torque.norm();
  torque_ = size > mechanics_.peak_torque ? Vec3(torque * (mechanics_.peak_torque / size)) : torque;
}

void WristModel::advance(double dt, const Quat& intended) {
  const int steps = std::max(1, static_cast<int>(std::ceil(dt / longest_turning_step - 1e-9)));
  const double h = dt / steps, squared = hand_lever * hand_lever;
  const double inertia = mechanics_.inertia + squared * hand_.mass, stiffness = squared * hand_.stiffness;
  // Hand and damping are integrated implicitly, so that a stiff hand stays stable; friction is then applied.
  const double resists = inertia + h * (mechanics_.damping + squared * hand_.damping) + h * h * stiffness;
  for (int k = 0; k < steps; ++k) {
    const Vec3 pull = torque_ + stiffness * turn(orientation_, intended);
    Vec3 spin = (inertia * spin_ + h * pull) / resists;
    const double speed = spin.norm(), stopped = h * mechanics_.friction / resists;
    spin *= speed > stopped ? 1 - stopped / speed : 0;
    spin_ = spin;
    orientation_ = (rotated_by(h * spin) * orientation_).normalized();
    energy_ -= h * torque_.dot(spin);
  }
}

Quat WristModel::measured() const {
  const double q = mechanics_.quantum;
  const Vec3 steps = turn(Quat::Identity(), orientation_) / q;
  return rotated_by(q * Vec3(steps.array().round().matrix()));
}

}  // namespace prosector
