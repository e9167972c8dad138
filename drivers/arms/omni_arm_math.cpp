#include "drivers/arms/omni_arm_math.h"

#include <cmath>
#include <numbers>

namespace prosector::omni {
namespace {

constexpr double height = 0.02335, reach = 0.16835;  // m: offsets of the frame's origin
constexpr double radians_a_count = 2 * std::numbers::pi / counts_a_turn;

}  // namespace

Vec3 tip(const Joints& j) {
  const double r = bar * (std::cos(j[1]) + std::sin(j[2]));
  return {std::sin(j[0]) * r, bar * (std::sin(j[1]) - std::cos(j[2])) + height, std::cos(j[0]) * r - reach};
}

Mat3 jacobian(const Joints& j) {
  const double r = bar * (std::cos(j[1]) + std::sin(j[2]));
  const double r2 = -bar * std::sin(j[1]), r3 = bar * std::cos(j[2]);
  const double s = std::sin(j[0]), c = std::cos(j[0]);
  Mat3 out;
  out.col(0) = Vec3(c * r, 0, -s * r);
  out.col(1) = Vec3(s * r2, bar * std::cos(j[1]), c * r2);
  out.col(2) = Vec3(s * r3, bar * std::sin(j[2]), c * r3);
  return out;
}

Quat orientation(const Joints& j, const Vec3& gimbal) {
  const auto about = [](double angle, const Vec3& axis) { return Quat(Eigen::AngleAxisd(angle, axis)); };
  return (about(j[0], Vec3::UnitY()) * about(j[2], -Vec3::UnitX()) * about(gimbal[0], Vec3::UnitY()) *
          about(gimbal[1], -Vec3::UnitX()) * about(gimbal[2], -Vec3::UnitZ()))
      .normalized();
}

Joints joints_of(const std::array<int, 3>& counts) {
  return docked + radians_a_count * Joints(counts[0], -counts[1], counts[2]);
}

Vec3 commands_for(const Joints& joints, const Vec3& force) {
  const Vec3 commands = jacobian(joints).transpose() * force / full_command_torque;
  const double most = commands.cwiseAbs().maxCoeff();
  return most > 1 ? Vec3(commands / most) : commands;
}

}  // namespace prosector::omni
