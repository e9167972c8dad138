#pragma once
// Displacement of a point of a rigid body under a twist.

#include "server/physics/mechanics/coupled/island.h"
#include "server/physics/mechanics/soft/laws/flattened_matrix.h"

namespace prosector {

using Mat36 = Eigen::Matrix<double, 3, 6>;

/// Returns the 3×6 Jacobian of the displacement of a point at `arm` from the centre of mass by its body's
/// twist: [1, −arm×].
inline Mat36 lever(const Vec3& arm) {
  Mat36 J;
  J << Mat3::Identity(), -cross_matrix(arm);
  return J;
}

}  // namespace prosector
