#pragma once
// Sparse Cholesky of a block matrix; the ordering and the pattern of the factor are found once.

#include <memory>
#include <span>

#include "server/physics/soft/matrices/block_matrix.h"

namespace prosector {

class Cholesky {
 public:
  /// Orders (approximate minimum degree) and analyses; the pattern must outlive this.
  explicit Cholesky(const BlockPattern& pattern);
  ~Cholesky();

  /// Factors the matrix with these blocks as LDLᵀ; false when it is not positive definite or not finite.
  bool factor(std::span<const Mat3> values);
  /// Computes z = A⁻¹·r with the last factor, 3n each.
  void solve(const double* r, double* z) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace prosector
