#pragma once
// Eigenvalues of symmetric 3×3 matrices by cyclic Jacobi rotations (Golub & Van Loan, §8.5), which keep the
// eigenvectors orthonormal even for nearly equal eigenvalues.

#include "common/math.h"

namespace prosector {

struct SymmetricEigen {
  Vec3 values;   // in no particular order
  Mat3 vectors;  // orthonormal columns
};

/// Returns the eigenvalues and eigenvectors of `A`, which must be symmetric and finite; only its upper
/// triangle is read.
SymmetricEigen symmetric_eigen(const Mat3& A);

}  // namespace prosector
