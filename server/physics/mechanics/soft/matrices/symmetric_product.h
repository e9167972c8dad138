#pragma once
// Products of symmetric matrices of 3×3 float blocks, each stored once, with vectors, with fused arithmetic
// if the CPU supports it. Vectors are double for conjugate gradients, float for the finest level of
// multigrid.

#include <cstddef>
#include <cstdint>

namespace prosector {

/// A block left of the diagonal: the transpose of a block right of the diagonal in an earlier row.
struct MirroredBlock {
  std::uint32_t column, block;
};

/// Off-diagonal blocks, column-major; `value` must be readable for one float beyond the last.
struct SymmetricBlocks {
  const std::size_t* begin;  // rows + 1 entries: start of the blocks right of the diagonal
  const std::uint32_t* column;
  const std::size_t* mirrored_begin;
  const MirroredBlock* mirrored;
  const float* value;
};

// ---- Rows first … last − 1 of n; vectors are 3n.
/// Computes y = scale·A·x + D·x with vectors and sums in double; D: the diagonal blocks.
void multiply(const SymmetricBlocks& A, std::size_t first, std::size_t last, double scale, const double* D,
              const double* x, double* y);
/// Computes the diagonal blocks for which rows sum to zero, symmetrised, 9 numbers per row.
void close_rows(const SymmetricBlocks& A, std::size_t first, std::size_t last, double* D);

/// Symmetric matrix with its diagonal blocks and their inverses.
struct SymmetricFloats {
  SymmetricBlocks blocks;
  const float *diagonal, *inverse;
};

/// Performs a Chebyshev step from zero, as the function of float_rows.h does.
void smooth_from_zero(const SymmetricFloats& A, std::size_t first, std::size_t last, const float* b,
                      float gain, float* d, float* z);
void smooth(const SymmetricFloats& A, std::size_t first, std::size_t last, const float* b, const float* z,
            float keep, float gain, float* d, float* to);
void residual(const SymmetricFloats& A, std::size_t first, std::size_t last, const float* b, const float* z,
              float* r);

}  // namespace prosector
