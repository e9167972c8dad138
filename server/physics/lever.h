#pragma once
// How points of a rigid body move with its twist.

#include "server/physics/island.h"
#include "server/physics/soft/laws/vec9.h"

namespace prosector {

using Mat36 = Eigen::Matrix<double, 3, 6>;

/// Returns the displacement of a point at `arm` from the centre of mass as a map of its body's twist: [1,
/// −arm×].
inline Mat36 lever(const Vec3& arm) {
  Mat36 J;
  J << Mat3::Identity(), -cross_matrix(arm);
  return J;
}

}  // namespace prosector
