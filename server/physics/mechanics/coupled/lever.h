#pragma once
// Displacement of a point of a rigid body under a twist.

#include "server/physics/mechanics/coupled/island.h"
#include "server/physics/mechanics/soft/laws/flattened_matrix.h"

namespace prosector::coupled {

using Mat36 = Eigen::Matrix<double, 3, 6>;

/// Returns the 3×6 Jacobian [1, −arm×] of the displacement of a point of a rigid body by the body's twist
/// (translation, then rotation). `arm`: vector (m) from the body's centre of mass to the point, world frame.
inline Mat36 lever(const Vec3& arm) {
  Mat36 J;
  J << Mat3::Identity(), -soft::cross_matrix(arm);
  return J;
}

}  // namespace prosector::coupled
