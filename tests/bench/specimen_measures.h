#pragma once
// Measures of a specimen that only benchmarks take.

#include <Eigen/SVD>
#include <limits>
#include <stdexcept>

#include "server/calibration/specimen.h"

namespace prosector {

/// Returns the angular momentum (kg·m²/s) about the room's origin.
inline Vec3 angular_momentum(const Specimen& specimen) {
  const VecX x = specimen.positions(), v = specimen.velocities();
  const VecX& mass = specimen.node_mass();
  Vec3 sum = Vec3::Zero();
  for (Eigen::Index i = 0; i < mass.size(); ++i)
    sum += mass[i] * Vec3(x.segment<3>(3 * i)).cross(Vec3(v.segment<3>(3 * i)));
  return sum;
}

/// Returns the largest distance (m) of a node's position in `x` from its position in `rest`, after `rest` has
/// been rigidly aligned with `x`. The alignment minimises the mean square distance of the nodes, weighted by
/// mass (Kabsch 1976). Infinite if x is not finite. Both are 3n, m.
inline double shape_error(const VecX& rest, const VecX& x, const VecX& node_mass) {
  if (!x.allFinite()) return std::numeric_limits<double>::infinity();
  const auto at_rest = rest.reshaped(3, node_mass.size()), now = x.reshaped(3, node_mass.size());
  const Vec3 rest_center = at_rest * node_mass / node_mass.sum(), center = now * node_mass / node_mass.sum();
  const Mat3 covariance =
      (now.colwise() - center) * node_mass.asDiagonal() * (at_rest.colwise() - rest_center).transpose();
  const Eigen::JacobiSVD<Mat3> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sense = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
  const Mat3 turn = svd.matrixU() * Vec3(1, 1, sense).asDiagonal() * svd.matrixV().transpose();
  return ((now.colwise() - center) - turn * (at_rest.colwise() - rest_center)).colwise().norm().maxCoeff();
}

/// Returns the index of the node whose rest position in `rest` (3n, m) is `place`. Throws std::logic_error if
/// there is none.
inline Eigen::Index node_at(const VecX& rest, const Vec3& place) {
  for (Eigen::Index i = 0; i < rest.size() / 3; ++i) {
    if ((rest.segment<3>(3 * i) - place).norm() < 1e-9) return i;
  }
  throw std::logic_error(
      "the benchmark specimen's mesh has no node at the position whose displacement is measured");
}

}  // namespace prosector
