#include "drivers/omni_arm_math.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace prosector::omni {
namespace {

constexpr double height = 0.02335, reach = 0.16835;  // m: of the origin
constexpr double radians_a_count = 2 * std::numbers::pi / counts_a_turn;
constexpr double straight = 1e-3;  // of a bar cubed: with a smaller determinant it has no way to push

}  // namespace

Vec3 tip(const Joints& j) {
  const double r = bar * (std::cos(j[1]) + std::sin(j[2]));
  return {-std::sin(j[0]) * r, bar * (std::sin(j[1]) - std::cos(j[2])) + height, std::cos(j[0]) * r - reach};
}

std::optional<Joints> joints_at(const Vec3& tip) {
  const double forward = tip.z() + reach, up = tip.y() - height;
  const double r = std::hypot(tip.x(), forward), d = std::hypot(r, up);
  if (!(d < 2 * bar) || !(d > 0)) return std::nullopt;
  // Both bars are as long: they lie to both sides of the line to the tip. The lower one's angle to the
  // horizontal is θ3 − π/2.
  const double middle = std::atan2(up, r), half = std::acos(d / (2 * bar));
  return Joints(std::atan2(-tip.x(), forward), middle + half, middle - half + std::numbers::pi / 2);
}

Mat3 jacobian(const Joints& j) {
  const double r = bar * (std::cos(j[1]) + std::sin(j[2]));
  const double r2 = -bar * std::sin(j[1]), r3 = bar * std::cos(j[2]);
  const double s = std::sin(j[0]), c = std::cos(j[0]);
  Mat3 out;
  out.col(0) = Vec3(-c * r, 0, -s * r);
  out.col(1) = Vec3(-s * r2, bar * std::cos(j[1]), c * r2);
  out.col(2) = Vec3(-s * r3, bar * std::sin(j[2]), c * r3);
  return out;
}

Quat orientation(const Joints& j, const Vec3& gimbal) {
  const auto about = [](double angle, const Vec3& axis) { return Quat(Eigen::AngleAxisd(angle, axis)); };
  return (about(-j[0], Vec3::UnitY()) * about(gimbal[0], Vec3::UnitY()) * about(gimbal[1], Vec3::UnitX()) *
          about(gimbal[2], Vec3::UnitZ()))
      .normalized();
}

Joints joints_of(const std::array<int, 3>& counts) {
  const double turned1 = radians_a_count * counts[0], turned2 = -radians_a_count * counts[1];
  // The third encoder turns with the upper bar, too.
  const double turned3 = radians_a_count * counts[2] - turned2;
  return docked + Joints(turned1, turned2, turned3);
}

std::array<int, 3> counts_of(const Joints& joints) {
  const Joints turned = joints - docked;
  const auto counts = [](double angle) { return static_cast<int>(std::lround(angle / radians_a_count)); };
  return {counts(turned[0]), counts(-turned[1]), counts(turned[2] + turned[1])};
}

Vec3 commands_for(const Joints& joints, const Vec3& force) {
  const Vec3 commands = jacobian(joints).transpose() * force / torque_of_full_command;
  const double most = commands.cwiseAbs().maxCoeff();
  if (!std::isfinite(most)) return Vec3::Zero();
  return most > 1 ? Vec3(commands / most) : commands;
}

Vec3 force_of(const Joints& joints, const Vec3& commands) {
  const Mat3 turned = jacobian(joints).transpose();
  if (std::abs(turned.determinant()) < straight * bar * bar * bar) return Vec3::Zero();
  return turned.inverse() * (torque_of_full_command * commands);
}

}  // namespace prosector::omni
