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

namespace prosector::coupled {

/// Sparse symmetric matrix with a 6×6 block for each rigid body and each coupled pair of bodies, and its
/// Cholesky factor.
class RigidBlock {
 public:
  using Pair = std::pair<std::size_t, std::size_t>;  // lower body first

  /// Begins a matrix for this number of rigid bodies, with a 6×6 block for each body and for each pair in
  /// `pairs`, and sets all blocks to zero. `pairs`: the pairs of bodies that may be coupled, lower index
  /// first.
  void begin(std::size_t bodies, std::span<const Pair> pairs);

  void set_zero();
  void add(std::size_t body, const Mat6& block) { diagonal_[rank_[body]] += block; }
  /// Adds the 6×6 `block` to the symmetric matrix at row a and column b, where a < b are indices of rigid
  /// bodies. Adds its transpose at row b and column a.
  void add(std::size_t a, std::size_t b, const Mat6& block);
  /// Computes the Cholesky factor of the matrix in place. Returns false if the matrix is not numerically
  /// positive definite; solve() must then not be called.
  bool factor();
  /// Solves A·z = r with the Cholesky factor of the matrix A; vectors have 6 values per rigid body. `z` and
  /// `r` must not overlap in memory.
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

}  // namespace prosector::coupled
