#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "server/physics/mechanics/soft/matrices/symmetric_product.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep; compiles this file once per instruction set

// Must follow foreach_target.h, which includes these headers again.
#include "server/physics/mechanics/soft/matrices/symmetric_product.h"
#include "server/physics/mechanics/soft/simd/four_lanes.h"

HWY_BEFORE_NAMESPACE();
namespace prosector::soft::HWY_NAMESPACE {

// Blocks right of the diagonal add columns scaled by an entry of x, with one sum per column, so that sums are
// independent. For blocks left of the diagonal, the transposes, entry c is the product of column c and x.
// `left[c]` accumulates the products and is summed once per row. A column is loaded with one entry of the
// next column, which is ignored.

/// Row sum in single precision.
struct RowSum {
  V4 right[3], left[3];

  HWY_INLINE RowSum() : right{zero4(), zero4(), zero4()}, left{zero4(), zero4(), zero4()} {}
  HWY_INLINE void add(const float* block, const float* x) {
    for (std::size_t c = 0; c < 3; ++c) right[c] = multiply_add(x[c], load4(block + 3 * c), right[c]);
  }
  /// Adds the transpose; reads four entries of x.
  HWY_INLINE void add_transposed(const float* block, const float* x) {
    const V4 v = load4(x);
    for (std::size_t c = 0; c < 3; ++c) left[c] = multiply_add(load4(block + 3 * c), v, left[c]);
  }
  HWY_INLINE void store(float* y) const {
    float r[3][4], l[3][4];
    for (std::size_t c = 0; c < 3; ++c) {
      store4(right[c], r[c]);
      store4(left[c], l[c]);
    }
    for (std::size_t c = 0; c < 3; ++c) y[c] = (r[0][c] + r[1][c] + r[2][c]) + (l[c][0] + l[c][1] + l[c][2]);
  }
};

struct WideRowSum {
  W4 right[3], left[3];

  HWY_INLINE WideRowSum()
      : right{wide_zero(), wide_zero(), wide_zero()}, left{wide_zero(), wide_zero(), wide_zero()} {}
  HWY_INLINE void add(const float* block, const double* x) {
    for (std::size_t c = 0; c < 3; ++c) right[c] = multiply_add(x[c], wide(block + 3 * c), right[c]);
  }
  HWY_INLINE void add_transposed(const float* block, const double* x) {
    const W4 v = wide(x);
    for (std::size_t c = 0; c < 3; ++c) left[c] = multiply_add(wide(block + 3 * c), v, left[c]);
  }
  HWY_INLINE void store(double* y) const {
    double r[3][4], l[3][4];
    for (std::size_t c = 0; c < 3; ++c) {
      HWY_NAMESPACE::store(right[c], r[c]);
      HWY_NAMESPACE::store(left[c], l[c]);
    }
    for (std::size_t c = 0; c < 3; ++c) y[c] = (r[0][c] + r[1][c] + r[2][c]) + (l[c][0] + l[c][1] + l[c][2]);
  }
};

/// Adds row i of A·x to `sum`. A mirrored block's column is never the last, so four entries of x can be read.
template <class Sum, class Number>
HWY_INLINE void row_product(const SymmetricBlocks& A, std::size_t i, const Number* x, Sum& sum) {
  for (std::size_t k = A.begin[i]; k < A.begin[i + 1]; ++k)
    sum.add(A.value + 9 * k, x + 3 * std::size_t{A.column[k]});
  for (std::size_t k = A.mirrored_begin[i]; k < A.mirrored_begin[i + 1]; ++k)
    sum.add_transposed(A.value + 9 * std::size_t{A.mirrored[k].block},
                       x + 3 * std::size_t{A.mirrored[k].column});
}

void product(const SymmetricBlocks& A, std::size_t first, std::size_t last, double scale, const double* D,
             const double* x, double* y) {
  for (std::size_t i = first; i < last; ++i) {
    WideRowSum sum;
    row_product(A, i, x, sum);
    double others[3];
    sum.store(others);
    const double *own = D + 9 * i, *xi = x + 3 * i;
    for (std::size_t c = 0; c < 3; ++c)
      y[3 * i + c] = scale * others[c] + (own[c] * xi[0] + own[3 + c] * xi[1] + own[6 + c] * xi[2]);
  }
}

/// Sum of blocks.
struct BlockSum {
  W4 column[3];

  HWY_INLINE BlockSum() : column{wide_zero(), wide_zero(), wide_zero()} {}
  HWY_INLINE void add(const float* block) {
    for (std::size_t c = 0; c < 3; ++c) column[c] = multiply_add(1, wide(block + 3 * c), column[c]);
  }
  HWY_INLINE void store(double (*to)[4]) const {
    for (std::size_t c = 0; c < 3; ++c) HWY_NAMESPACE::store(column[c], to[c]);
  }
};

void close(const SymmetricBlocks& A, std::size_t first, std::size_t last, double* D) {
  for (std::size_t i = first; i < last; ++i) {
    BlockSum right, mirrored;
    for (std::size_t k = A.begin[i]; k < A.begin[i + 1]; ++k) right.add(A.value + 9 * k);
    for (std::size_t k = A.mirrored_begin[i]; k < A.mirrored_begin[i + 1]; ++k)
      mirrored.add(A.value + 9 * std::size_t{A.mirrored[k].block});
    double r[3][4], m[3][4];
    right.store(r);
    mirrored.store(m);
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t k = 0; k < 3; ++k)
        D[9 * i + 3 * c + k] = -0.5 * ((r[c][k] + m[k][c]) + (r[k][c] + m[c][k]));
  }
}

HWY_INLINE void row_residual(const SymmetricFloats& A, std::size_t i, const float* b, const float* z,
                             float* r) {
  RowSum sum;
  sum.add(A.diagonal + 9 * i, z + 3 * i);
  row_product(A.blocks, i, z, sum);
  float product[3];
  sum.store(product);
  for (std::size_t c = 0; c < 3; ++c) r[c] = b[3 * i + c] - product[c];
}

HWY_INLINE void row_solve(const SymmetricFloats& A, std::size_t i, const float* r, float* out) {
  RowSum sum;
  sum.add(A.inverse + 9 * i, r);
  sum.store(out);
}

void from_zero(const SymmetricFloats& A, std::size_t first, std::size_t last, const float* b, float gain,
               float* d, float* z) {
  for (std::size_t i = first; i < last; ++i) {
    float e[3];
    row_solve(A, i, b + 3 * i, e);
    for (std::size_t c = 0; c < 3; ++c) z[3 * i + c] = d[3 * i + c] = gain * e[c];
  }
}

void step(const SymmetricFloats& A, std::size_t first, std::size_t last, const float* b, const float* z,
          float keep, float gain, float* d, float* to) {
  for (std::size_t i = first; i < last; ++i) {
    float r[3], e[3];
    row_residual(A, i, b, z, r);
    row_solve(A, i, r, e);
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t at = 3 * i + c;
      d[at] = keep * d[at] + gain * e[c];
      to[at] = z[at] + d[at];
    }
  }
}

void rest(const SymmetricFloats& A, std::size_t first, std::size_t last, const float* b, const float* z,
          float* r) {
  for (std::size_t i = first; i < last; ++i) row_residual(A, i, b, z, r + 3 * i);
}

}  // namespace prosector::soft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace prosector::soft {

HWY_EXPORT(product);
HWY_EXPORT(close);
HWY_EXPORT(from_zero);
HWY_EXPORT(step);
HWY_EXPORT(rest);

void multiply(const SymmetricBlocks& A, std::size_t first, std::size_t last, double scale, const double* D,
              const double* x, double* y) {
  HWY_DYNAMIC_DISPATCH(product)(A, first, last, scale, D, x, y);
}
void close_rows(const SymmetricBlocks& A, std::size_t first, std::size_t last, double* D) {
  HWY_DYNAMIC_DISPATCH(close)(A, first, last, D);
}
void smooth_from_zero(const SymmetricFloats& A, std::size_t first, std::size_t last, const float* b,
                      float gain, float* d, float* z) {
  HWY_DYNAMIC_DISPATCH(from_zero)(A, first, last, b, gain, d, z);
}
void smooth(const SymmetricFloats& A, std::size_t first, std::size_t last, const float* b, const float* z,
            float keep, float gain, float* d, float* to) {
  HWY_DYNAMIC_DISPATCH(step)(A, first, last, b, z, keep, gain, d, to);
}
void residual(const SymmetricFloats& A, std::size_t first, std::size_t last, const float* b, const float* z,
              float* r) {
  HWY_DYNAMIC_DISPATCH(rest)(A, first, last, b, z, r);
}

}  // namespace prosector::soft
#endif
