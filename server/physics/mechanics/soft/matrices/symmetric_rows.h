#pragma once
// Symmetric stiffness matrices in single precision with each block stored once, for conjugate gradients and
// multigrid. Reading the matrix takes most of a product's time, so this is twice as fast as storing both
// triangles.

#include <span>
#include <vector>

#include "server/physics/mechanics/soft/base/scratch.h"
#include "server/physics/mechanics/soft/matrices/block_matrix.h"
#include "server/physics/mechanics/soft/matrices/symmetric_product.h"

namespace prosector::soft {

/// Sparsity pattern of a symmetric matrix of 3×3 blocks. Only blocks right of the diagonal are stored, row by
/// row. The blocks of row i left of the diagonal are the transposes of blocks in earlier rows.
class SymmetricPattern {
 public:
  explicit SymmetricPattern(const BlockPattern& pattern) { fit(pattern); }
  void fit(const BlockPattern& pattern);

  std::size_t rows() const { return begin_.size() - 1; }
  std::size_t blocks() const { return column_.size(); }
  std::size_t begin(std::size_t row) const { return begin_[row]; }
  /// Returns the columns of the row's blocks right of the diagonal, ascending. Their blocks are stored
  /// consecutively, starting at index begin(row).
  std::span<const std::uint32_t> right(std::size_t row) const {
    return std::span(column_).subspan(begin_[row], begin_[row + 1] - begin_[row]);
  }
  /// Returns the row's blocks left of the diagonal, by ascending column. Each is the transpose of a stored
  /// block of an earlier row.
  std::span<const MirroredBlock> left(std::size_t row) const {
    return std::span(mirrored_).subspan(mirrored_begin_[row],
                                        mirrored_begin_[row + 1] - mirrored_begin_[row]);
  }
  SymmetricBlocks blocks_of(const std::vector<float>& values) const {
    return {begin_.data(), column_.data(), mirrored_begin_.data(), mirrored_.data(), values.data()};
  }

 private:
  std::vector<std::size_t> begin_, mirrored_begin_;
  std::vector<std::uint32_t> column_;
  std::vector<MirroredBlock> mirrored_;
};

/// Symmetric stiffness matrix whose rows sum to zero, because a rigid translation causes no strain.
/// Off-diagonal blocks are single precision. The diagonal blocks, minus the sums of the others, are double
/// precision. So rounding causes no force under a translation, and momentum is conserved as in double
/// precision.
struct SymmetricRows {
  explicit SymmetricRows(const SymmetricPattern& pattern) { fit(pattern); }
  /// Resizes the arrays of blocks to the number of blocks and rows of `pattern`. The values are undefined
  /// afterwards.
  void fit(const SymmetricPattern& pattern) {
    fit_scratch(right, 9 * pattern.blocks() + 1);
    fit_scratch(diagonal, pattern.rows());
  }

  /// Sets the off-diagonal blocks to `share` times those of a double-precision matrix with the blocks
  /// `values` of `pattern`. `own`: the pattern of this matrix.
  void set(const SymmetricPattern& own, const BlockPattern& pattern, double share,
           std::span<const Mat3> values);
  /// Writes `scale` times the off-diagonal blocks, in both triangles, to the blocks `values` of a
  /// double-precision matrix with `pattern`. Leaves its diagonal blocks unchanged. `own`: the pattern of this
  /// matrix.
  void write(const SymmetricPattern& own, const BlockPattern& pattern, double scale,
             std::span<Mat3> values) const;
  /// Computes the diagonal blocks from the off-diagonal ones, so that each row of the matrix sums to zero.
  void close(const SymmetricPattern& pattern);

  std::vector<float> right;  // 9 per block, column-major, plus one readable float
  std::vector<Mat3> diagonal;
};

/// Computes y = scale·A·x + D·x for 3n vectors. A: the off-diagonal blocks of the symmetric matrix K; D:
/// diagonal blocks, which replace those of K.
void multiply(const SymmetricPattern& pattern, const SymmetricRows& K, double scale, std::span<const Mat3> D,
              const double* x, double* y);

}  // namespace prosector::soft
