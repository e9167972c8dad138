#pragma once
// The rotation between two directions.

#include "common/math.h"

namespace prosector {

/// Returns the smallest rotation that maps direction `from` to direction `to`. For opposite directions it is
/// a half turn about any perpendicular axis. Neither direction needs unit length. The function is in a
/// separate file because the Eigen decomposition that it uses takes seconds to compile.
Quat rotation_between(const Vec3& from, const Vec3& to);

}  // namespace prosector
