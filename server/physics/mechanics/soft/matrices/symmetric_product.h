#pragma once
// Products of symmetric matrices of 3×3 float blocks, each stored once, with vectors, with fused arithmetic
// if the CPU supports it. Vectors are double for conjugate gradients, float for the finest level of
// multigrid.

#include <cstddef>
#include <cstdint>

namespace prosector::soft {

/// Block left of the diagonal of a symmetric matrix of which only blocks right of the diagonal are stored. It
/// is the transpose of the stored block with index `block`, in the earlier row `column`.
struct MirroredBlock {
  std::uint32_t column, block;
};

/// Off-diagonal 3×3 float blocks of a symmetric matrix, column-major. Each is stored once, right of the
/// diagonal; `mirrored` lists for each row the blocks left of it. `value` must be readable for one float
/// beyond the last block, because SIMD loads read that far.
struct SymmetricBlocks {
  const std::size_t* begin;  // rows + 1 entries: start of the blocks right of the diagonal
  const std::uint32_t* column;
  const std::size_t* mirrored_begin;
  const MirroredBlock* mirrored;
  const float* value;
};

// ---- Rows first … last − 1 of n; vectors are 3n.
/// Computes rows first … last − 1 of y = scale·A·x + D·x, with vectors and sums in double precision. A: the
/// off-diagonal blocks; D: the 3×3 diagonal blocks, column-major.
void multiply(const SymmetricBlocks& A, std::size_t first, std::size_t last, double scale, const double* D,
              const double* x, double* y);
/// Computes the diagonal blocks D for which rows first … last − 1 of the matrix sum to zero: minus the sum of
/// each row's off-diagonal blocks, made exactly symmetric. Writes 9 numbers per row.
void close_rows(const SymmetricBlocks& A, std::size_t first, std::size_t last, double* D);

/// Symmetric matrix of 3×3 float blocks for smoothing: its off-diagonal blocks, its diagonal blocks, and the
/// inverses of the diagonal blocks.
struct SymmetricFloats {
  SymmetricBlocks blocks;
  const float *diagonal, *inverse;
};

/// Performs the first Chebyshev smoothing step for A·z = b from z = 0: d = gain·D⁻¹b, z = d, for rows first …
/// last − 1. D⁻¹ are the inverses of A's diagonal blocks.
void smooth_from_zero(const SymmetricFloats& A, std::size_t first, std::size_t last, const float* b,
                      float gain, float* d, float* z);
void smooth(const SymmetricFloats& A, std::size_t first, std::size_t last, const float* b, const float* z,
            float keep, float gain, float* d, float* to);
void residual(const SymmetricFloats& A, std::size_t first, std::size_t last, const float* b, const float* z,
              float* r);

}  // namespace prosector::soft
