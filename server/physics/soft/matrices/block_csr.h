#pragma once
// Sparse matrices of small dense blocks, rows compressed: what a multigrid hierarchy is computed from, once
// per topology.

#include <algorithm>
#include <cstdint>
#include <vector>

#include "common/math.h"
#include "server/physics/parallel.h"

namespace prosector {

/// Columns ascend within a row.
template <int R, int C>
struct BlockCsr {
  using Block = Eigen::Matrix<double, R, C>;
  std::vector<std::size_t> begin{0};  // one more than rows
  std::vector<std::uint32_t> column;
  std::vector<Block> value;

  std::size_t rows() const { return begin.size() - 1; }
  void add(std::uint32_t to, const Block& block) {
    column.push_back(to);
    value.push_back(block);
  }
  void close_row() { begin.push_back(column.size()); }
};

inline constexpr std::size_t csr_rows_per_chunk = 64;

/// Rows [first, last) of A·B.
template <int R, int K, int C>
BlockCsr<R, C> product_rows(const BlockCsr<R, K>& A, const BlockCsr<K, C>& B, std::size_t columns,
                            std::size_t first, std::size_t last) {
  using Block = typename BlockCsr<R, C>::Block;
  BlockCsr<R, C> out;
  std::vector<Block> sum(columns);
  std::vector<std::size_t> seen(columns, 0);  // row + 1 that last touched the column
  std::vector<std::uint32_t> touched;
  for (std::size_t i = first; i < last; ++i) {
    touched.clear();
    for (std::size_t a = A.begin[i]; a < A.begin[i + 1]; ++a) {
      for (std::size_t b = B.begin[A.column[a]]; b < B.begin[A.column[a] + 1]; ++b) {
        const std::uint32_t j = B.column[b];
        if (seen[j] != i + 1) {
          seen[j] = i + 1;
          sum[j].setZero();
          touched.push_back(j);
        }
        sum[j].noalias() += A.value[a] * B.value[b];
      }
    }
    std::sort(touched.begin(), touched.end());
    for (std::uint32_t j : touched) out.add(j, sum[j]);
    out.close_row();
  }
  return out;
}

/// Returns the parts one below the other.
template <int R, int C>
BlockCsr<R, C> stacked(const std::vector<BlockCsr<R, C>>& parts) {
  BlockCsr<R, C> out;
  std::vector<std::size_t> at;  // where each part's blocks go
  for (const BlockCsr<R, C>& part : parts) {
    at.push_back(out.begin.back());
    for (std::size_t i = 0; i < part.rows(); ++i) out.begin.push_back(at.back() + part.begin[i + 1]);
  }
  out.column.resize(out.begin.back());
  out.value.resize(out.begin.back());
  parallel_chunks(parts.size(), 1, [&](std::size_t, std::size_t, std::size_t p) {
    const auto to = static_cast<std::ptrdiff_t>(at[p]);
    std::copy(parts[p].column.begin(), parts[p].column.end(), out.column.begin() + to);
    std::copy(parts[p].value.begin(), parts[p].value.end(), out.value.begin() + to);
  });
  return out;
}

/// Returns A·B; `columns`: of B. Sums run in the order of A's row.
template <int R, int K, int C>
BlockCsr<R, C> product(const BlockCsr<R, K>& A, const BlockCsr<K, C>& B, std::size_t columns) {
  std::vector<BlockCsr<R, C>> parts(chunk_count(A.rows(), csr_rows_per_chunk));
  parallel_chunks(A.rows(), csr_rows_per_chunk, [&](std::size_t first, std::size_t last, std::size_t part) {
    parts[part] = product_rows(A, B, columns, first, last);
  });
  return stacked(parts);
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

/// Returns the inverses of the diagonal blocks, which must be there and positive definite.
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

}  // namespace prosector
