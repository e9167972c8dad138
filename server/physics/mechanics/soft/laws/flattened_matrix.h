#pragma once
// 3×3 matrices as vectors of 9 (column-major), for tangents.

#include "server/physics/mechanics/soft/laws/constitutive_law.h"

namespace prosector::soft {

using Vec9 = Eigen::Matrix<double, 9, 1>;

inline Vec9 vec(const Mat3& A) {
  return Eigen::Map<const Vec9>(A.data());
}

/// Returns the skew-symmetric 3×3 matrix [v]ₓ of the cross product: cross_matrix(v)·x = v × x.
inline Mat3 cross_matrix(const Vec3& v) {
  Mat3 A;
  A << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
  return A;
}

/// Adds c times the outer product of q with itself to the matrix H: H += c·q·qᵀ.
inline void add_outer(double c, const Vec9& q, Mat9& H) {
  for (int j = 0; j < 9; ++j) H.col(j) += (c * q[j]) * q;
}

}  // namespace prosector::soft
