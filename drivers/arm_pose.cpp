#include "drivers/arm_pose.h"

namespace prosector {
namespace {

constexpr double reach = 2;     // m
constexpr double slack = 1e-3;  // by how much columns may not be unit vectors that are square to each other

}  // namespace

bool is_rotation(const Mat3& turn) {
  return turn.allFinite() && (turn.transpose() * turn).isIdentity(slack) && turn.determinant() > 0;
}

std::optional<Pose> arm_pose(const Vec3& place, const Mat3& turn) {
  if (!place.allFinite() || place.norm() > reach || !is_rotation(turn)) return std::nullopt;
  return Pose{place, Quat(turn).normalized()};
}

}  // namespace prosector
