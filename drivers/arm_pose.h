#pragma once
// What an API says of a stylus' pose becomes one, if it can be one.

#include <optional>

#include "common/math.h"

namespace prosector {

/// Tells whether a matrix is one of rotation, but for what rounding does.
bool is_rotation(const Mat3& turn);

/// Returns the pose of a place (m, the arm's frame) and a matrix of rotation. Returns nothing for what is no
/// number, farther than any arm reaches, or no rotation.
std::optional<Pose> arm_pose(const Vec3& place, const Mat3& turn);

}  // namespace prosector
