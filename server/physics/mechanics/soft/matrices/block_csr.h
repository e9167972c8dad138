#pragma once
// Sparse matrices of small dense blocks in compressed row storage, used to compute a multigrid hierarchy once
// per topology.

#include <algorithm>
#include <cstdint>
#include <vector>

#include "common/math.h"
#include "server/physics/base/parallel.h"

namespace prosector::soft {

/// Sparse matrix of dense R×C blocks in compressed row storage: columns and blocks of all rows, concatenated,
/// and the start of each row. Columns ascend within a row.
template <int R, int C>
struct BlockCsr {
  using Block = Eigen::Matrix<double, R, C>;
  std::vector<std::size_t> begin{0};  // rows + 1 entries
  std::vector<std::uint32_t> column;
  std::vector<Block> value;

  std::size_t rows() const { return begin.size() - 1; }
  void reserve(std::size_t rows, std::size_t blocks) {
    begin.reserve(rows + 1);
    column.reserve(blocks);
    value.reserve(blocks);
  }
  void add(std::uint32_t to, const Block& block) {
    column.push_back(to);
    value.push_back(block);
  }
  void close_row() { begin.push_back(column.size()); }
};

inline constexpr std::size_t csr_rows_per_chunk = 64;

/// Finds the columns of the nonzero blocks in rows first … last − 1 of the product A·B. Appends them to
/// `column`, ascending within each row, and sets ends[i] to the size of `column` after row i. `columns`:
/// number of columns of B.
template <int R, int K, int C>
void product_columns(const BlockCsr<R, K>& A, const BlockCsr<K, C>& B, std::size_t columns, std::size_t first,
                     std::size_t last, std::vector<std::uint32_t>& column, std::size_t* ends) {
  std::vector<std::size_t> seen(columns, 0);  // row + 1 in which the column was last seen
  for (std::size_t i = first; i < last; ++i) {
    const auto begun = static_cast<std::ptrdiff_t>(column.size());
    for (std::size_t a = A.begin[i]; a < A.begin[i + 1]; ++a)
      for (std::size_t b = B.begin[A.column[a]]; b < B.begin[A.column[a] + 1]; ++b) {
        const std::uint32_t j = B.column[b];
        if (seen[j] == i + 1) continue;
        seen[j] = i + 1;
        column.push_back(j);
      }
    std::sort(column.begin() + begun, column.end());
    ends[i] = column.size();
  }
}

/// Computes the blocks of rows first … last − 1 of the product A·B into `out`, whose columns must be known.
/// Sums are in the order of the blocks in A's row, so results do not depend on the number of threads.
/// `columns`: number of columns of B.
template <int R, int K, int C>
void product_blocks(const BlockCsr<R, K>& A, const BlockCsr<K, C>& B, std::size_t columns, std::size_t first,
                    std::size_t last, BlockCsr<R, C>& out) {
  std::vector<std::size_t> place(columns);
  for (std::size_t i = first; i < last; ++i) {
    for (std::size_t k = out.begin[i]; k < out.begin[i + 1]; ++k) {
      place[out.column[k]] = k;
      out.value[k].setZero();
    }
    for (std::size_t a = A.begin[i]; a < A.begin[i + 1]; ++a)
      for (std::size_t b = B.begin[A.column[a]]; b < B.begin[A.column[a] + 1]; ++b)
        out.value[place[B.column[b]]].noalias() += A.value[a] * B.value[b];
  }
}

/// Returns the product A·B of two block sparse matrices, computed in parallel. `columns`: number of columns
/// of B.
template <int R, int K, int C>
BlockCsr<R, C> product(const BlockCsr<R, K>& A, const BlockCsr<K, C>& B, std::size_t columns) {
  BlockCsr<R, C> out;
  out.begin.resize(A.rows() + 1);
  std::vector<std::vector<std::uint32_t>> parts(chunk_count(A.rows(), csr_rows_per_chunk));
  parallel_chunks(A.rows(), csr_rows_per_chunk, [&](std::size_t first, std::size_t last, std::size_t part) {
    product_columns(A, B, columns, first, last, parts[part], out.begin.data() + 1);
  });
  for (std::size_t part = 0, i = 0; part < parts.size(); ++part) {
    const std::size_t before = out.column.size();
    for (; i < std::min(A.rows(), (part + 1) * csr_rows_per_chunk); ++i) out.begin[i + 1] += before;
    out.column.insert(out.column.end(), parts[part].begin(), parts[part].end());
  }
  out.value.resize(out.column.size());
  parallel_chunks(A.rows(), csr_rows_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
    product_blocks(A, B, columns, first, last, out);
  });
  return out;
}

template <int R, int C>
BlockCsr<C, R> transposed(const BlockCsr<R, C>& A, std::size_t columns) {
  BlockCsr<C, R> out;
  out.begin.assign(columns + 1, 0);
  for (std::uint32_t j : A.column) ++out.begin[j + 1];
  for (std::size_t j = 0; j < columns; ++j) out.begin[j + 1] += out.begin[j];
  out.column.resize(A.column.size());
  out.value.resize(A.value.size());
  std::vector<std::size_t> next(out.begin.begin(), out.begin.end() - 1);
  for (std::size_t i = 0; i < A.rows(); ++i) {
    for (std::size_t k = A.begin[i]; k < A.begin[i + 1]; ++k) {
      const std::size_t to = next[A.column[k]]++;
      out.column[to] = static_cast<std::uint32_t>(i);
      out.value[to] = A.value[k].transpose();
    }
  }
  return out;
}

/// Returns the inverse of each diagonal block of A. All diagonal blocks must be present and positive
/// definite.
template <int B>
std::vector<Eigen::Matrix<double, B, B>> inverse_diagonal(const BlockCsr<B, B>& A) {
  std::vector<Eigen::Matrix<double, B, B>> out(A.rows());
  parallel_chunks(A.rows(), csr_rows_per_chunk, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto first = A.column.begin() + static_cast<std::ptrdiff_t>(A.begin[i]);
      const auto last = A.column.begin() + static_cast<std::ptrdiff_t>(A.begin[i + 1]);
      const auto at = std::lower_bound(first, last, static_cast<std::uint32_t>(i)) - A.column.begin();
      out[i] = A.value[static_cast<std::size_t>(at)].inverse();
    }
  });
  return out;
}

}  // namespace prosector::soft
