#pragma once
// Readings of a tracker with known truth and the FASTRAK's noise.

#include <cmath>
#include <numbers>
#include <random>

#include "common/math.h"

namespace prosector {

inline constexpr double degree = std::numbers::pi / 180;
inline constexpr double fastrak_noise = 0.8e-3;              // m RMS, all three axes together
inline constexpr double fastrak_turn_noise = 0.15 * degree;  // rad RMS, all three together

class SimulatedTracker {
 public:
  explicit SimulatedTracker(unsigned seed) : random_(seed) {}

  /// Returns a vector whose squared length is `rms`² on average.
  Vec3 noise(double rms) {
    return rms / std::sqrt(3.0) * Vec3(normal_(random_), normal_(random_), normal_(random_));
  }
  double normal() { return normal_(random_); }
  double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random_); }
  Vec3 inside(double half) { return {uniform(-half, half), uniform(-half, half), uniform(-half, half)}; }
  Quat orientation() { return Quat(normal(), normal(), normal(), normal()).normalized(); }

  Pose read(const Pose& truth, double noise_m = fastrak_noise, double noise_rad = fastrak_turn_noise) {
    const Vec3 turn = noise(noise_rad);
    const double angle = turn.norm();
    const Quat dq = angle > 0 ? Quat(Eigen::AngleAxisd(angle, turn / angle)) : Quat::Identity();
    return {truth.p + noise(noise_m), (dq * truth.q).normalized()};
  }

 private:
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
};

}  // namespace prosector
