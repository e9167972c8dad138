#include "server/physics/soft/block_matrix.h"

#include <algorithm>
#include <set>

#include "server/physics/parallel.h"

namespace prosector {
namespace {

constexpr std::size_t rows_per_chunk = 128;

}  // namespace

BlockPattern::BlockPattern(const Connectivity& elements) {
  const std::size_t nodes = elements.nodes();
  std::vector<std::set<std::uint32_t>> neighbours(nodes);
  for (std::uint32_t i = 0; i < nodes; ++i) neighbours[i].insert(i);
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const auto n = elements.element(e);
    for (std::uint32_t i : n) neighbours[i].insert(n.begin(), n.end());
  }
  row_begin_.push_back(0);
  for (const auto& row : neighbours) {
    column_.insert(column_.end(), row.begin(), row.end());
    row_begin_.push_back(column_.size());
  }
  const auto find = [&](std::uint32_t i, std::uint32_t j) {
    const auto first = column_.begin() + static_cast<std::ptrdiff_t>(row_begin_[i]);
    const auto last = column_.begin() + static_cast<std::ptrdiff_t>(row_begin_[i + 1]);
    return static_cast<std::size_t>(std::lower_bound(first, last, j) - column_.begin());
  };

  std::vector<std::vector<std::uint32_t>> sums(column_.size());
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const auto n = elements.element(e);
    for (std::size_t a = 0; a < n.size(); ++a) {
      for (std::size_t b = a + 1; b < n.size(); ++b) {
        const std::size_t block = elements.first_block(e) + Connectivity::pair_index(a, b, n.size());
        sums[find(n[a], n[b])].push_back(static_cast<std::uint32_t>(block));
      }
    }
  }
  term_begin_.push_back(0);
  for (const auto& sum : sums) {
    terms_.insert(terms_.end(), sum.begin(), sum.end());
    term_begin_.push_back(terms_.size());
  }
  mirror_.resize(column_.size());
  for (std::uint32_t i = 0; i < nodes; ++i) {
    diagonal_.push_back(find(i, i));
    for (std::size_t k = begin(i); k < end(i); ++k) mirror_[k] = find(column_[k], i);
  }
}

void BlockPattern::gather(std::span<const Mat3> elements, double scale, std::span<const Mat3> base,
                          std::span<Mat3> values) const {
  parallel_chunks(rows(), rows_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t i = first; i < last; ++i) {
      for (std::size_t k = diagonal_[i] + 1; k < end(i); ++k) {
        Mat3 sum = Mat3::Zero();
        if (!base.empty()) sum = scale * base[k];
        double* const total = sum.data();
        for (std::size_t t = term_begin_[k]; t < term_begin_[k + 1]; ++t) {
          const double* const block = elements[terms_[t]].data();
          for (int entry = 0; entry < 9; ++entry) total[entry] += block[entry];
        }
        values[k] = sum;
        values[mirror_[k]] = sum.transpose();
      }
    }
  });
  close_rows(values);
}

/// Diagonal blocks from the others; symmetric exactly, which the sum is only to rounding.
void BlockPattern::close_rows(std::span<Mat3> values) const {
  parallel_chunks(rows(), rows_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t i = first; i < last; ++i) {
      Mat3 sum = Mat3::Zero();
      for (std::size_t k = begin(i); k < diagonal_[i]; ++k) sum += values[k];
      for (std::size_t k = diagonal_[i] + 1; k < end(i); ++k) sum += values[k];
      values[diagonal_[i]] = -0.5 * (sum + sum.transpose());
    }
  });
}

void BlockPattern::multiply(std::span<const Mat3> values, const double* x, double* y) const {
  parallel_chunks(rows(), rows_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t i = first; i < last; ++i) {
      double y0 = 0, y1 = 0, y2 = 0;
      for (std::size_t k = begin(i); k < end(i); ++k) {
        const double* A = values[k].data();
        const double* p = x + 3 * std::size_t{column_[k]};
        y0 += A[0] * p[0] + A[3] * p[1] + A[6] * p[2];
        y1 += A[1] * p[0] + A[4] * p[1] + A[7] * p[2];
        y2 += A[2] * p[0] + A[5] * p[1] + A[8] * p[2];
      }
      y[3 * i] = y0;
      y[3 * i + 1] = y1;
      y[3 * i + 2] = y2;
    }
  });
}

}  // namespace prosector
