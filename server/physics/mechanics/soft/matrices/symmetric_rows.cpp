#include "server/physics/mechanics/soft/matrices/symmetric_rows.h"

#include "server/physics/base/parallel.h"

namespace prosector::soft {
namespace {

constexpr std::size_t symmetric_rows_per_chunk = 256;

}  // namespace

void SymmetricPattern::fit(const BlockPattern& pattern) {
  begin_.assign(1, 0);
  mirrored_begin_.assign(1, 0);
  column_.clear();
  column_.reserve(pattern.blocks() / 2);
  for (std::size_t i = 0; i < pattern.rows(); ++i) {
    for (std::size_t k = pattern.diagonal(i) + 1; k < pattern.end(i); ++k)
      column_.push_back(pattern.column(k));
    begin_.push_back(column_.size());
    mirrored_begin_.push_back(mirrored_begin_.back() + pattern.diagonal(i) - pattern.begin(i));
  }
  mirrored_.resize(column_.size());
  std::vector<std::size_t> next(mirrored_begin_.begin(), mirrored_begin_.end() - 1);
  for (std::size_t i = 0; i < rows(); ++i)
    for (std::size_t k = begin_[i]; k < begin_[i + 1]; ++k)
      mirrored_[next[column_[k]]++] = {static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(k)};
}

void SymmetricRows::set(const SymmetricPattern& own, const BlockPattern& pattern, double share,
                        std::span<const Mat3> values) {
  parallel_short_chunks(pattern.rows(), symmetric_rows_per_chunk,
                        [&](std::size_t first, std::size_t last, std::size_t) {
                          for (std::size_t i = first; i < last; ++i) {
                            float* to = right.data() + 9 * own.begin(i);
                            for (std::size_t k = pattern.diagonal(i) + 1; k < pattern.end(i); ++k)
                              for (int entry = 0; entry < 9; ++entry)
                                *to++ = static_cast<float>(share * values[k].data()[entry]);
                          }
                        });
}

void SymmetricRows::write(const SymmetricPattern& own, const BlockPattern& pattern, double scale,
                          std::span<Mat3> values) const {
  const auto block = [&](std::size_t k) -> Mat3 {
    return scale * Eigen::Map<const Eigen::Matrix3f>(right.data() + 9 * k).cast<double>();
  };
  for (std::size_t i = 0; i < pattern.rows(); ++i) {
    std::size_t to = pattern.begin(i);
    for (const MirroredBlock& mirrored : own.left(i)) values[to++] = block(mirrored.block).transpose();
    ++to;
    for (std::size_t k = 0; k < own.right(i).size(); ++k) values[to++] = block(own.begin(i) + k);
  }
}

void SymmetricRows::close(const SymmetricPattern& pattern) {
  parallel_short_chunks(pattern.rows(), symmetric_rows_per_chunk,
                        [&](std::size_t first, std::size_t last, std::size_t) {
                          close_rows(pattern.blocks_of(right), first, last, diagonal.front().data());
                        });
}

void multiply(const SymmetricPattern& pattern, const SymmetricRows& K, double scale, std::span<const Mat3> D,
              const double* x, double* y) {
  const SymmetricBlocks A = pattern.blocks_of(K.right);
  parallel_short_chunks(pattern.rows(), symmetric_rows_per_chunk,
                        [&](std::size_t first, std::size_t last, std::size_t) {
                          multiply(A, first, last, scale, D[0].data(), x, y);
                        });
}

}  // namespace prosector::soft
