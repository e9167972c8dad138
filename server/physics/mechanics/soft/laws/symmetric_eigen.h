#pragma once
// Eigenvalues of symmetric 3×3 matrices by cyclic Jacobi rotations (Golub & Van Loan, §8.5), which keep the
// eigenvectors orthonormal even for nearly equal eigenvalues.

#include "common/math.h"

namespace prosector::soft {

struct SymmetricEigen {
  Vec3 values;   // in no particular order
  Mat3 vectors;  // orthonormal columns
};

/// Computes the eigenvalues and eigenvectors of the symmetric, finite matrix `A`. Reads only its upper
/// triangle.
SymmetricEigen symmetric_eigen(const Mat3& A);

}  // namespace prosector::soft
