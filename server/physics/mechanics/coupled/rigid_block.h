#pragma once
// The rigid bodies' block of an island's Hessian, factored. Stacks of rigid bodies are then solved exactly,
// for any mass ratio, and the iterative solver handles only the tissue between them.
//
// Block Cholesky factorisation with 6 × 6 blocks; the body with the fewest remaining neighbours is eliminated
// first (minimum degree: Tinney and Walker 1967). Allocates only for more bodies than before.

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "server/physics/mechanics/coupled/island.h"

namespace prosector {

/// Sparse symmetric matrix of 6 × 6 blocks and its Cholesky factor.
class RigidBlock {
 public:
  using Pair = std::pair<std::size_t, std::size_t>;  // lower body first

  /// Begins a matrix with this number of bodies, of which these pairs may be coupled. Sets all blocks to
  /// zero.
  void begin(std::size_t bodies, std::span<const Pair> pairs);

  void set_zero();
  void add(std::size_t body, const Mat6& block) { diagonal_[rank_[body]] += block; }
  /// Adds `block` at row a and column b, a < b, and its transpose at row b and column a.
  void add(std::size_t a, std::size_t b, const Mat6& block);
  /// Factors the matrix. Returns false if it is not numerically positive definite; solve() is then undefined.
  bool factor();
  /// Computes z = A⁻¹r, 6 numbers per body. `z` and `r` must not overlap.
  void solve(const Eigen::Ref<const VecX>& r, Eigen::Ref<VecX> z) const;

 private:
  using Rank = std::uint32_t;  // a body's index in the elimination order

  void order();
  Mat6& below(Rank row, Rank column);

  std::vector<std::vector<std::uint32_t>> neighbours_;  // of bodies not eliminated yet, ascending
  std::vector<char> eliminated_;
  std::vector<Rank> rank_;              // by body
  std::vector<std::uint32_t> body_;     // by rank
  std::vector<std::size_t> first_;      // by column: first index in rows_ and below_
  std::vector<Rank> rows_;              // of the blocks below the diagonal, ascending in each column
  std::vector<Mat6> diagonal_, below_;  // before factor(): the matrix; after: its Cholesky factor
  mutable VecX work_;                   // by rank
};

}  // namespace prosector
