#include "server/physics/mechanics/soft/solvers/cholesky.h"

#include <Eigen/SparseCholesky>

namespace prosector::soft {

using SparseMatrix = Eigen::SparseMatrix<double>;

struct Cholesky::Impl {
  const BlockPattern& pattern;
  SparseMatrix lower;  // values are in the order in which walk() visits the blocks
  Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower> ldlt;
  VecX permuted;

  explicit Impl(const BlockPattern& p) : pattern(p) {}

  /// Calls f(block, row in block, column in block) for the lower triangle, column by column.
  template <class F>
  void walk(const F& f) const {
    for (std::size_t j = 0; j < pattern.rows(); ++j) {
      for (int c = 0; c < 3; ++c) {
        // Column j from the diagonal down = row j from the diagonal on, transposed.
        for (std::size_t k = pattern.diagonal(j); k < pattern.end(j); ++k) {
          for (int r = k == pattern.diagonal(j) ? c : 0; r < 3; ++r) f(j, k, r, c);
        }
      }
    }
  }
};

Cholesky::Cholesky(const BlockPattern& pattern) : impl_(std::make_unique<Impl>(pattern)) {
  std::vector<Eigen::Triplet<double>> entries;
  impl_->walk([&](std::size_t j, std::size_t k, int r, int c) {
    entries.emplace_back(static_cast<int>(3 * pattern.column(k)) + r, static_cast<int>(3 * j) + c, 1.0);
  });
  const auto n = static_cast<Eigen::Index>(3 * pattern.rows());
  impl_->lower.resize(n, n);
  impl_->lower.setFromTriplets(entries.begin(), entries.end());
  impl_->ldlt.analyzePattern(impl_->lower);
  impl_->permuted.resize(n);
}

Cholesky::~Cholesky() = default;

bool Cholesky::factor(std::span<const Mat3> values) {
  double* entry = impl_->lower.valuePtr();
  impl_->walk([&](std::size_t, std::size_t k, int r, int c) { *entry++ = values[k](c, r); });
  impl_->ldlt.factorize(impl_->lower);
  return impl_->ldlt.info() == Eigen::Success && impl_->ldlt.vectorD().minCoeff() > 0;
}

void Cholesky::solve(const double* r, double* z) const {
  const auto n = impl_->permuted.size();
  VecX& y = impl_->permuted;
  y.noalias() = impl_->ldlt.permutationP() * Eigen::Map<const VecX>(r, n);
  impl_->ldlt.matrixL().solveInPlace(y);
  y.array() /= impl_->ldlt.vectorD().array();
  impl_->ldlt.matrixU().solveInPlace(y);
  Eigen::Map<VecX>(z, n).noalias() = impl_->ldlt.permutationPinv() * y;
}

}  // namespace prosector::soft
