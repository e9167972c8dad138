#pragma once
// Rows of single-precision blocks times vectors, with fused arithmetic if the CPU supports it. Used for the
// coarse levels of the multigrid preconditioner and the transfers between them. Blocks are column-major with
// 3 or 6 rows and columns.

#include <cstddef>
#include <cstdint>

namespace prosector::soft {

/// Sparse matrix of float blocks with R rows and C columns, column-major: the start of each row, and the
/// column and values of each block. `value` must be readable for one float beyond its last block, because
/// SIMD loads read that far.
struct FloatBlocks {
  const std::size_t* begin;  // rows + 1 entries
  const std::uint32_t* column;
  const float* value;
};
/// Computes rows first … last − 1 of the product y = A·x, where A has blocks of R×C floats.
template <int R, int C>
void multiply(const FloatBlocks& A, std::size_t first, std::size_t last, const float* x, float* y);

/// Square sparse matrix of 6×6 float blocks, and the inverse of its diagonal block for each row.
struct FloatRows {
  FloatBlocks blocks;
  const float* inverse;
};

/// Performs the first Chebyshev smoothing step for A·z = b from z = 0: d = gain·D⁻¹b, z = d, for rows first …
/// last − 1. D⁻¹ are the inverses of A's diagonal blocks.
void smooth_from_zero(const FloatRows& A, std::size_t first, std::size_t last, const float* b, float gain,
                      float* d, float* z);
/// Performs a Chebyshev smoothing step for A·z = b: d = keep·d + gain·D⁻¹(b − A·z), to = z + d, for rows
/// first … last − 1. D⁻¹ are the inverses of A's diagonal blocks.
void smooth(const FloatRows& A, std::size_t first, std::size_t last, const float* b, const float* z,
            float keep, float gain, float* d, float* to);
/// Computes rows first … last − 1 of the residual r = b − A·z.
void residual(const FloatRows& A, std::size_t first, std::size_t last, const float* b, const float* z,
              float* r);

}  // namespace prosector::soft
