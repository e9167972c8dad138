#include "client/haptics/passivity.h"

#include <algorithm>
#include <cmath>

#include "common/rotation.h"

namespace prosector {
namespace {

constexpr double max_damping = 20;           // N·s/m: more makes light arms oscillate at 1 kHz
constexpr double max_energy_reserve = 2e-3;  // J: energy reserve above the stored energy; energy dissipated
                                             // long ago must not justify energy delivered now
constexpr double least_speed = 1e-3;         // m/s: at lower speeds damping dissipates nothing
constexpr double lever = 0.05;               // m: lever arm that converts angular to linear velocity
constexpr double damping_rise_time = 0.005,
                 damping_fall_time =
                     0.03;  // s, in which the full damping is switched on and off: steps would cause jolts

}  // namespace

void Passivity::observe(const Pose& stylus, double stored, double surroundings, double dt) {
  if (known_) {
    const double work =  // on the hand, J
        acts_.force.dot(stylus.p - stylus_.p) + acts_.torque.dot(turn(stylus_.q, stylus.q));
    (work > 0 ? book_.given : book_.taken) += std::abs(work);
    level_ += surroundings * dt - work;
    level_ = std::min(level_, stored + max_energy_reserve);
  }
  known_ = true;
  stylus_ = stylus;
}

Wrench Passivity::damp(const Wrench& wanted, const HandMotion& motion, double dt) {
  const double squared = motion.velocity.squaredNorm() + lever * lever * motion.spin.squaredNorm();
  const double speed = std::max(least_speed, std::sqrt(squared));
  const double needed = std::min(max_damping, std::max(0., -level_) / (speed * speed * dt));
  damping_ = std::clamp(needed, damping_ - max_damping * dt / damping_fall_time,
                        damping_ + max_damping * dt / damping_rise_time);
  return {wanted.force - damping_ * motion.velocity, wanted.torque - damping_ * lever * lever * motion.spin};
}

}  // namespace prosector
