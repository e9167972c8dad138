#pragma once
// Symmetric sparse matrices of 3×3 blocks, one row of blocks per node.

#include <cstdint>
#include <span>
#include <vector>

#include "server/physics/mechanics/soft/base/connectivity.h"

namespace prosector::soft {

/// Sparsity pattern of a body's matrices of 3×3 blocks, one row per node, and the element blocks that are
/// summed in each. Both triangles are stored, so a product with a vector reads rows only, and rows can run in
/// parallel.
class BlockPattern {
 public:
  /// Builds the sparsity pattern of matrices in which nodes of the same element are coupled. `elements` must
  /// outlive this object.
  explicit BlockPattern(const Connectivity& elements);
  /// Updates the sparsity pattern after the elements were updated for the mesh edit `edit`. Recomputes only
  /// the rows of the nodes in `edit.nodes`.
  void follow(const MeshEdit& edit);
  /// Updates the sparsity pattern after the elements changed. `kept`: the nodes that remain, with their new
  /// indices. `nodes`: ascending nodes of elements that were added, removed or changed; only their rows are
  /// recomputed. The other elements must keep their order.
  void follow(const Kept& kept, std::span<const std::uint32_t> nodes);

  std::size_t rows() const { return row_begin_.size() - 1; }
  std::size_t blocks() const { return column_.size(); }
  std::size_t begin(std::size_t row) const { return row_begin_[row]; }
  std::size_t end(std::size_t row) const { return row_begin_[row + 1]; }
  std::uint32_t column(std::size_t block) const { return column_[block]; }
  std::size_t diagonal(std::size_t row) const { return diagonal_[row]; }

  // ---- Contributions to a row right of its diagonal, in the order of the elements.
  const Incidence& incidence() const { return incidence_; }
  /// Returns the blocks of a row to which the elements' blocks are added. The list has an entry for each pair
  /// of an element at the row's node and a node of that element with a higher index. Pairs are in the order
  /// of the elements. The entry is the index of the pair's block in the row, counted from the first block
  /// right of the diagonal.
  std::span<const std::uint32_t> places(std::size_t row) const {
    return std::span(place_).subspan(place_begin_[row], place_begin_[row + 1] - place_begin_[row]);
  }

  /// Computes the blocks of a matrix: values = scale·base + the sum of the elements' blocks, which are in the
  /// connectivity's order. Each sum is in the order of the elements, so it is bitwise equal for any number of
  /// threads. `base`: empty, or another matrix of this pattern whose rows sum to zero.
  void gather(std::span<const Mat3> elements, double scale, std::span<const Mat3> base,
              std::span<Mat3> values) const;

  /// Computes the product y = A·x for 3n vectors, where A has the blocks `values` in this pattern.
  void multiply(std::span<const Mat3> values, const double* x, double* y) const;

 private:
  void replace_rows(const Kept& kept, std::span<const std::uint32_t> nodes);
  void find_mirrors();
  void close_rows(std::span<Mat3> values) const;

  const Connectivity& elements_;
  Incidence incidence_;
  std::vector<std::size_t> row_begin_;
  std::vector<std::uint32_t> column_;  // ascending within a row
  std::vector<std::size_t> diagonal_;
  std::vector<std::size_t> mirror_;  // per block of the upper triangle: index of its transpose
  std::vector<std::size_t> place_begin_;
  std::vector<std::uint32_t> place_;
};

}  // namespace prosector::soft
