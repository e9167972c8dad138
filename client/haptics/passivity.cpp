#include "client/haptics/passivity.h"

#include <algorithm>
#include <cmath>

namespace prosector {
namespace {

constexpr double most_damping = 20;   // N·s/m: more than that makes light arms rattle at 1 kHz
constexpr double most_saved = 2e-3;   // J: what was spent long ago doesn't excuse what is given now
constexpr double least_speed = 1e-3;  // m/s: below it damping has no way to act on

}  // namespace

void Passivity::observe(const Vec3& position, double stored, double surroundings, double dt) {
  if (known_) {
    const double work = force_.dot(position - position_);  // on the hand
    (work > 0 ? book_.given : book_.taken) += std::abs(work);
    level_ += surroundings * dt - work;
    level_ = std::min(level_, stored + most_saved);
  }
  known_ = true;
  position_ = position;
}

Vec3 Passivity::damp(const Vec3& force, const Vec3& velocity, double dt) const {
  const double speed = velocity.norm();
  if (level_ >= 0 || speed < least_speed) return force;
  return force - std::min(most_damping, -level_ / (speed * speed * dt)) * velocity;
}

}  // namespace prosector
