#pragma once
// Symmetric stiffness matrices in single precision with each block stored once, for conjugate gradients and
// multigrid. Reading the matrix takes most of a product's time, so this is twice as fast as storing both
// triangles.

#include <span>
#include <vector>

#include "server/physics/mechanics/soft/base/scratch.h"
#include "server/physics/mechanics/soft/matrices/block_matrix.h"
#include "server/physics/mechanics/soft/matrices/symmetric_product.h"

namespace prosector {

/// Sparsity pattern. Blocks right of the diagonal are stored, row by row; row i reads its other blocks from
/// earlier rows.
class SymmetricPattern {
 public:
  explicit SymmetricPattern(const BlockPattern& pattern) { fit(pattern); }
  void fit(const BlockPattern& pattern);

  std::size_t rows() const { return begin_.size() - 1; }
  std::size_t blocks() const { return column_.size(); }
  std::size_t begin(std::size_t row) const { return begin_[row]; }
  /// Returns the columns right of the diagonal, ascending; their blocks start at begin(row).
  std::span<const std::uint32_t> right(std::size_t row) const {
    return std::span(column_).subspan(begin_[row], begin_[row + 1] - begin_[row]);
  }
  /// Returns the columns left of the diagonal, ascending, and their blocks, which are the transposes.
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

/// Symmetric matrix whose rows sum to zero, because a rigid translation causes no strain. Off-diagonal blocks
/// are single precision. The diagonal blocks are minus their sums in double precision. So rounding causes no
/// force under a translation, and momentum is conserved as in double precision.
struct SymmetricRows {
  explicit SymmetricRows(const SymmetricPattern& pattern) { fit(pattern); }
  /// Resizes to the present pattern; values are undefined.
  void fit(const SymmetricPattern& pattern) {
    fit_scratch(right, 9 * pattern.blocks() + 1);
    fit_scratch(diagonal, pattern.rows());
  }

  /// Sets the off-diagonal blocks to share·(a double matrix of `pattern`).
  void set(const SymmetricPattern& own, const BlockPattern& pattern, double share,
           std::span<const Mat3> values);
  /// Writes scale·(the off-diagonal blocks) to a double matrix of `pattern`.
  void write(const SymmetricPattern& own, const BlockPattern& pattern, double scale,
             std::span<Mat3> values) const;
  /// Computes the diagonal blocks from the others.
  void close(const SymmetricPattern& pattern);

  std::vector<float> right;  // 9 per block, column-major, plus one readable float
  std::vector<Mat3> diagonal;
};

/// Computes y = scale·(K's off-diagonal blocks)·x + D·x, D the diagonal blocks; 3n vectors.
void multiply(const SymmetricPattern& pattern, const SymmetricRows& K, double scale, std::span<const Mat3> D,
              const double* x, double* y);

}  // namespace prosector
