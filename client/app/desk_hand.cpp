#include "client/app/desk_hand.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace prosector {
namespace {

constexpr double least_reach = 0.15, most_reach = 4;
constexpr double wrist_to_fingertips = 0.18;  // m, fingers stretched
constexpr double hand_pitch = -0.5;           // rad: fingers point into the picture and down
constexpr double most_bend = 1.5;             // rad from there, either way
constexpr double open = 0.1, fist = 0.9;      // flexion
constexpr double close_per_s = 6;             // flexion per second when the button goes down

}  // namespace

void DeskHand::reach(double by) {
  reach_ = std::clamp(reach_ + by, least_reach, most_reach);
}

void DeskHand::turn(double roll, double bend) {
  roll_ = std::remainder(roll_ + roll, 2 * std::numbers::pi);
  bend_ = std::clamp(bend_ + bend, -most_bend, most_bend);
}

void DeskHand::advance(double seconds) {
  const double wanted = closed_ ? fist : open;
  flexion_ += std::clamp(wanted - flexion_, -close_per_s * seconds, close_per_s * seconds);
}

Pose DeskHand::pose(const Ray& pointer, double yaw) const {
  const Vec3 fingertips = pointer.from + reach_ * pointer.along;
  const Quat q(Eigen::AngleAxisd(yaw, Vec3::UnitY()) * Eigen::AngleAxisd(-roll_, Vec3::UnitZ()) *
               Eigen::AngleAxisd(hand_pitch + bend_, Vec3::UnitX()));
  return {fingertips + q * Vec3(0, 0, wrist_to_fingertips), q};
}

}  // namespace prosector
