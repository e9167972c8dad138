#pragma once
// The rotation that turns one direction into another.

#include "common/math.h"

namespace prosector {

/// Turns the direction `from` into the direction `to` by the least angle; of two opposite ones, by any half
/// turn. Neither needs to be of unit length. Defined in a file of its own, for Eigen's decomposition behind
/// it takes seconds to compile.
Quat rotation_between(const Vec3& from, const Vec3& to);

}  // namespace prosector
