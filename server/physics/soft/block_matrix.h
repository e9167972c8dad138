#pragma once
// Symmetric sparse matrices of 3×3 blocks, one row of blocks per node.

#include <cstdint>
#include <span>
#include <vector>

#include "server/physics/soft/connectivity.h"

namespace prosector {

/// Where the blocks of a body's matrices are, and which element blocks each of them sums: both triangles are
/// stored, so that a product reads rows only and rows may run in parallel.
class BlockPattern {
 public:
  explicit BlockPattern(const Connectivity& elements);

  std::size_t rows() const { return row_begin_.size() - 1; }
  std::size_t blocks() const { return column_.size(); }
  std::size_t begin(std::size_t row) const { return row_begin_[row]; }
  std::size_t end(std::size_t row) const { return row_begin_[row + 1]; }
  std::uint32_t column(std::size_t block) const { return column_[block]; }
  std::size_t diagonal(std::size_t row) const { return diagonal_[row]; }

  /// values = scale·base + Σ over the elements' blocks (in the connectivity's order), each sum in order of
  /// the elements: no matter who computes it, its bits are the same. `base` is empty or another matrix of
  /// this pattern whose rows sum to zero.
  void gather(std::span<const Mat3> elements, double scale, std::span<const Mat3> base,
              std::span<Mat3> values) const;

  /// y = A·x for 3n vectors.
  void multiply(std::span<const Mat3> values, const double* x, double* y) const;

 private:
  void close_rows(std::span<Mat3> values) const;

  std::vector<std::size_t> row_begin_;
  std::vector<std::uint32_t> column_;  // ascending within a row
  std::vector<std::size_t> diagonal_;
  std::vector<std::size_t> mirror_;      // per block of the upper triangle: its transpose
  std::vector<std::size_t> term_begin_;  // per block; the lower triangle and the diagonal have none
  std::vector<std::uint32_t> terms_;     // the element blocks in each sum
};

}  // namespace prosector
