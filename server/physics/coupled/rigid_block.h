#pragma once
// The rigid bodies' part of an island's Hessian, factored. What rests on what is then solved exactly, however
// heavy the one and light the other, and the linear solver is left with the tissue between.
//
// Cholesky's factorisation in blocks of 6 × 6, the body with the fewest neighbours left eliminated first
// (minimum degree: Tinney and Walker 1967). Allocates only for more than there ever was.

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "server/physics/island.h"

namespace prosector {

class RigidBlock {
 public:
  using Pair = std::pair<std::size_t, std::size_t>;  // lower body first

  /// Begins a matrix of so many bodies, of which these pairs may be joined. All blocks are then zero.
  void begin(std::size_t bodies, std::span<const Pair> pairs);

  void set_zero();
  void add(std::size_t body, const Mat6& block) { diagonal_[rank_[body]] += block; }
  /// Adds to the block of row a and column b, a < b; its transpose is added with it.
  void add(std::size_t a, std::size_t b, const Mat6& block);
  /// Factors the matrix; false when it is not positive definite to rounding: there is nothing to solve with
  /// then.
  bool factor();
  /// Computes z = A⁻¹r, 6 numbers a body. `z` must not be where `r` is.
  void solve(const Eigen::Ref<const VecX>& r, Eigen::Ref<VecX> z) const;

 private:
  using Rank = std::uint32_t;  // a body's place in the order of elimination

  void order();
  Mat6& below(Rank row, Rank column);

  std::vector<std::vector<std::uint32_t>> neighbours_;  // of bodies not eliminated yet, ascending
  std::vector<char> eliminated_;
  std::vector<Rank> rank_;              // by body
  std::vector<std::uint32_t> body_;     // by rank
  std::vector<std::size_t> first_;      // of rows_ and below_, by column
  std::vector<Rank> rows_;              // of the blocks below the diagonal, ascending in each column
  std::vector<Mat6> diagonal_, below_;  // before factor(): the matrix; after: its Cholesky factor
  mutable VecX work_;                   // by rank
};

}  // namespace prosector
