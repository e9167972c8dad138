#pragma once
// Rows of float blocks times float vectors, with fused arithmetic where the CPU has it: the coarse levels of
// the multigrid preconditioner and the ways between them. Blocks are column-major, of 3 or 6 rows and
// columns.

#include <cstddef>
#include <cstdint>

namespace prosector {

/// Blocks of R rows and C columns. `value` must be readable for one float beyond its last block, here and
/// below.
struct FloatBlocks {
  const std::size_t* begin;  // one more than rows
  const std::uint32_t* column;
  const float* value;
};
/// Computes y = A·x, rows first … last − 1.
template <int R, int C>
void multiply(const FloatBlocks& A, std::size_t first, std::size_t last, const float* x, float* y);

/// A square matrix of 6×6 blocks and the inverses of its diagonal ones, one a row.
struct FloatRows {
  FloatBlocks blocks;
  const float* inverse;
};

/// Makes a Chebyshev step from zero: d = gain·D⁻¹b, z = d, for rows first … last − 1.
void smooth_from_zero(const FloatRows& A, std::size_t first, std::size_t last, const float* b, float gain,
                      float* d, float* z);
/// Makes a Chebyshev step: d = keep·d + gain·D⁻¹(b − A·z), to = z + d.
void smooth(const FloatRows& A, std::size_t first, std::size_t last, const float* b, const float* z,
            float keep, float gain, float* d, float* to);
/// Computes r = b − A·z.
void residual(const FloatRows& A, std::size_t first, std::size_t last, const float* b, const float* z,
              float* r);

}  // namespace prosector
