#include "client/haptics/passivity.h"

#include <algorithm>
#include <cmath>

#include "common/rotation.h"

namespace prosector {
namespace {

constexpr double most_damping = 20;   // N·s/m: more than that makes light arms rattle at 1 kHz
constexpr double most_saved = 2e-3;   // J: what was spent long ago doesn't excuse what is given now
constexpr double least_speed = 1e-3;  // m/s: below it damping has no way to act on
constexpr double lever = 0.05;        // m: a turn is damped as a way at that distance
constexpr double sets_in = 0.005, lets_go = 0.03;  // s, in which all of it comes and goes: it must not jolt

}  // namespace

void Passivity::observe(const Pose& stylus, double stored, double surroundings, double dt) {
  if (known_) {
    const double work =  // on the hand
        acts_.force.dot(stylus.p - stylus_.p) + acts_.torque.dot(turn(stylus_.q, stylus.q));
    (work > 0 ? book_.given : book_.taken) += std::abs(work);
    level_ += surroundings * dt - work;
    level_ = std::min(level_, stored + most_saved);
  }
  known_ = true;
  stylus_ = stylus;
}

Wrench Passivity::damp(const Wrench& wanted, const HandMotion& motion, double dt) {
  const double squared = motion.velocity.squaredNorm() + lever * lever * motion.spin.squaredNorm();
  const double speed = std::max(least_speed, std::sqrt(squared));
  const double needed = std::min(most_damping, std::max(0., -level_) / (speed * speed * dt));
  damping_ =
      std::clamp(needed, damping_ - most_damping * dt / lets_go, damping_ + most_damping * dt / sets_in);
  return {wanted.force - damping_ * motion.velocity, wanted.torque - damping_ * lever * lever * motion.spin};
}

}  // namespace prosector
