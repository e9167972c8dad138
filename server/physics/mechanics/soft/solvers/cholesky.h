#pragma once
// Sparse Cholesky factorisation of a block matrix; ordering and symbolic analysis are done once.

#include <memory>
#include <span>

#include "server/physics/mechanics/soft/matrices/block_matrix.h"

namespace prosector::soft {

class Cholesky {
 public:
  /// Computes an ordering (approximate minimum degree) and the symbolic factorisation of matrices with the
  /// sparsity `pattern`, which must outlive this object.
  explicit Cholesky(const BlockPattern& pattern);
  ~Cholesky();

  /// Factors the matrix whose 3×3 blocks are `values`, in the pattern's order, as LDLᵀ. Returns false if the
  /// matrix is not positive definite or not finite.
  bool factor(std::span<const Mat3> values);
  /// Solves A·z = r (3n values each) with the factors of the matrix A last passed to factor().
  void solve(const double* r, double* z) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace prosector::soft
