#pragma once
// Rows of single-precision blocks times vectors, with fused arithmetic if the CPU supports it. Used for the
// coarse levels of the multigrid preconditioner and the transfers between them. Blocks are column-major with
// 3 or 6 rows and columns.

#include <cstddef>
#include <cstdint>

namespace prosector {

/// Blocks of R rows and C columns. `value` must be readable for one float beyond its last block, also in the
/// functions below.
struct FloatBlocks {
  const std::size_t* begin;  // rows + 1 entries
  const std::uint32_t* column;
  const float* value;
};
/// Computes y = A·x, rows first … last − 1.
template <int R, int C>
void multiply(const FloatBlocks& A, std::size_t first, std::size_t last, const float* x, float* y);

/// Square matrix of 6×6 blocks and the inverses of its diagonal blocks, one per row.
struct FloatRows {
  FloatBlocks blocks;
  const float* inverse;
};

/// Performs a Chebyshev step from zero: d = gain·D⁻¹b, z = d, for rows first … last − 1.
void smooth_from_zero(const FloatRows& A, std::size_t first, std::size_t last, const float* b, float gain,
                      float* d, float* z);
/// Performs a Chebyshev step: d = keep·d + gain·D⁻¹(b − A·z), to = z + d.
void smooth(const FloatRows& A, std::size_t first, std::size_t last, const float* b, const float* z,
            float keep, float gain, float* d, float* to);
/// Computes r = b − A·z.
void residual(const FloatRows& A, std::size_t first, std::size_t last, const float* b, const float* z,
              float* r);

}  // namespace prosector
