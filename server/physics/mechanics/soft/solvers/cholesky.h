#pragma once
// Sparse Cholesky factorisation of a block matrix; ordering and symbolic analysis are done once.

#include <memory>
#include <span>

#include "server/physics/mechanics/soft/matrices/block_matrix.h"

namespace prosector {

class Cholesky {
 public:
  /// Computes the ordering (approximate minimum degree) and the symbolic factorisation. The pattern must
  /// outlive this object.
  explicit Cholesky(const BlockPattern& pattern);
  ~Cholesky();

  /// Factors the matrix with these blocks as LDLᵀ. Returns false if it is not positive definite or not
  /// finite.
  bool factor(std::span<const Mat3> values);
  /// Computes z = A⁻¹·r with the last factorisation, 3n each.
  void solve(const double* r, double* z) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace prosector
