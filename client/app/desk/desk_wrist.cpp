#include "client/app/desk/desk_wrist.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "client/app/desk/cut_drawing.h"

namespace prosector {
namespace {

constexpr double hand_yaw_offset = 1.0;  // rad about +y: fingers point ahead and to the left of the gaze
constexpr double across = 0.7;  // rad between the gaze and the fingers: the hand enters from below the frame
constexpr double lowest_lift = -0.6, highest_lift = 0.4;  // rad above the horizontal
constexpr double highest_over_level =
    -0.25;                             // rad, over a horizontal surface, where the wrist must not be below it
constexpr double lift_speed = 2;       // rad/s
constexpr double most_bend = 1.5;      // rad from the initial position, in either direction
constexpr double turn_back_per_s = 4;  // fraction per second by which the rotation due to cuts decays
constexpr double rotated_tolerance = 1e-6;  // rad

}  // namespace

void DeskWrist::turn(double roll, double bend) {
  if (!std::isfinite(roll) || !std::isfinite(bend)) return;
  roll_ = std::remainder(roll_ + roll, 2 * std::numbers::pi);
  bend_ = std::clamp(bend_ + bend, -most_bend, most_bend);
}

void DeskWrist::face(double view_yaw) {
  yaw_ = view_yaw + hand_yaw_offset;
}

void DeskWrist::lift_fingers(double pitch, double level, double seconds) {
  const double flat = std::clamp(level, 0.0, 1.0);
  const double highest = flat * highest_over_level + (1 - flat) * highest_lift;
  const double to = std::clamp(across - pitch, lowest_lift, highest);
  lift_ += std::clamp(to - lift_, -lift_speed * seconds, lift_speed * seconds);
}

void DeskWrist::follow_cut(const Quat& rotation) {
  rotated_ = (before_cuts().conjugate() * rotation).normalized();
}

bool DeskWrist::rotate_towards(const Quat& rotation, double angle) {
  const Quat to = before_cuts().conjugate() * rotation;
  rotated_ = rotated_towards(rotated_, to, angle);
  return rotated_.angularDistance(to) < rotated_tolerance;
}

void DeskWrist::turn_back(double seconds) {
  rotated_ = rotated_.slerp(std::min(1.0, turn_back_per_s * seconds), Quat::Identity());
}

/// Returns the wrist rotation set by wheel and view.
Quat DeskWrist::before_cuts() const {
  return Quat(Eigen::AngleAxisd(yaw_, Vec3::UnitY()) * Eigen::AngleAxisd(bend_, Vec3::UnitX()) *
              Eigen::AngleAxisd(-roll_, Vec3::UnitZ()) * Eigen::AngleAxisd(lift_, Vec3::UnitX()));
}

}  // namespace prosector
