#pragma once
// Symmetric stiffness matrices in single precision, each block once: what conjugate gradients and multigrid
// multiply with. Reading it is most of what a product takes, so it is half as long as with both triangles.

#include <span>
#include <vector>

#include "server/physics/soft/base/scratch.h"
#include "server/physics/soft/matrices/block_matrix.h"
#include "server/physics/soft/matrices/symmetric_product.h"

namespace prosector {

/// Where the blocks are: those to the right of the diagonal are stored, row by row; row i reads the others
/// from the rows above.
class SymmetricPattern {
 public:
  explicit SymmetricPattern(const BlockPattern& pattern) { fit(pattern); }
  void fit(const BlockPattern& pattern);

  std::size_t rows() const { return begin_.size() - 1; }
  std::size_t blocks() const { return column_.size(); }
  std::size_t begin(std::size_t row) const { return begin_[row]; }
  /// Columns right of the diagonal, ascending; their blocks are those from begin(row) on.
  std::span<const std::uint32_t> right(std::size_t row) const {
    return std::span(column_).subspan(begin_[row], begin_[row + 1] - begin_[row]);
  }
  /// Columns left of it, ascending, and their blocks, which are the transposes.
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

/// A matrix whose rows sum to zero, as moving as a whole strains nothing. Its off-diagonal blocks are single;
/// the diagonal ones are minus their sums in double, so that rounding makes no force of a translation, and
/// momentum is conserved as in double.
struct SymmetricRows {
  explicit SymmetricRows(const SymmetricPattern& pattern) { fit(pattern); }
  /// Fits to the pattern as it is; its values are anything.
  void fit(const SymmetricPattern& pattern) {
    fit_scratch(right, 9 * pattern.blocks() + 1);
    fit_scratch(diagonal, pattern.rows());
  }

  /// Sets to share·(a double matrix of `pattern`), but the diagonal.
  void set(const SymmetricPattern& own, const BlockPattern& pattern, double share,
           std::span<const Mat3> values);
  /// Writes scale·(these blocks) into a double matrix of `pattern`, but the diagonal.
  void write(const SymmetricPattern& own, const BlockPattern& pattern, double scale,
             std::span<Mat3> values) const;
  /// Computes diagonal blocks from the others.
  void close(const SymmetricPattern& pattern);

  std::vector<float> right;  // 9 a block, column-major, and room to read one more
  std::vector<Mat3> diagonal;
};

/// Computes y = scale·(K's off-diagonal blocks)·x + D·x, D the diagonal ones; 3n vectors.
void multiply(const SymmetricPattern& pattern, const SymmetricRows& K, double scale, std::span<const Mat3> D,
              const double* x, double* y);

}  // namespace prosector
