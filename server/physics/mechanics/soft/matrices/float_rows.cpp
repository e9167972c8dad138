#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "server/physics/mechanics/soft/matrices/float_rows.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep; compiles this file once per instruction set

// Must follow foreach_target.h, which includes these headers again.
#include "server/physics/mechanics/soft/matrices/float_rows.h"
#include "server/physics/mechanics/soft/simd/four_lanes.h"

HWY_BEFORE_NAMESPACE();
namespace prosector::soft::HWY_NAMESPACE {

/// Column of B floats: the first four and, for six, the last four.
template <int B>
struct Column {
  V4 head, tail;

  static HWY_INLINE Column zero() { return {zero4(), zero4()}; }
  static HWY_INLINE Column load(const float* p) {
    if constexpr (B == 3) {
      return {load4(p), zero4()};
    } else {
      return {load4(p), load4(p + B - 4)};
    }
  }
  /// Returns this + s·v.
  HWY_INLINE Column plus(float s, const Column& v) const {
    if constexpr (B == 3) {
      return {multiply_add(s, v.head, head), tail};
    } else {
      return {multiply_add(s, v.head, head), multiply_add(s, v.tail, tail)};
    }
  }
  HWY_INLINE void store(float* p) const {
    if constexpr (B == 3) {
      float all[4];
      store4(head, all);
      for (int k = 0; k < 3; ++k) p[k] = all[k];
    } else {
      store4(tail, p + B - 4);
      store4(head, p);
    }
  }
};

template <int R, int C>
HWY_INLINE Column<R> block_times(const float* block, const float* x, Column<R> sum) {
  for (int c = 0; c < C; ++c) sum = sum.plus(x[c], Column<R>::load(block + R * c));
  return sum;
}

/// Computes even + Σ A_ij x_j with two independent sums, which can be computed in parallel.
template <int R, int C>
HWY_INLINE void row_product(const FloatBlocks& A, std::size_t i, const float* x, Column<R> even, float* y) {
  Column<R> odd = Column<R>::zero();
  const std::size_t last = A.begin[i + 1];
  std::size_t k = A.begin[i];
  for (; k + 1 < last; k += 2) {
    even = block_times<R, C>(A.value + R * C * k, x + C * std::size_t{A.column[k]}, even);
    odd = block_times<R, C>(A.value + R * C * (k + 1), x + C * std::size_t{A.column[k + 1]}, odd);
  }
  if (k < last) even = block_times<R, C>(A.value + R * C * k, x + C * std::size_t{A.column[k]}, even);
  even.plus(1, odd).store(y);
}

template <int R, int C>
void product(const FloatBlocks& A, std::size_t first, std::size_t last, const float* x, float* y) {
  for (std::size_t i = first; i < last; ++i) row_product<R, C>(A, i, x, Column<R>::zero(), y + R * i);
}

constexpr std::size_t B = 6;

HWY_INLINE void row_residual(const FloatRows& A, std::size_t i, const float* b, const float* z, float* r) {
  float product[B];
  row_product<B, B>(A.blocks, i, z, Column<B>::zero(), product);
  for (std::size_t c = 0; c < B; ++c) r[c] = b[B * i + c] - product[c];
}

HWY_INLINE void row_solve(const FloatRows& A, std::size_t i, const float* r, float* out) {
  block_times<B, B>(A.inverse + B * B * i, r, Column<B>::zero()).store(out);
}

void from_zero(const FloatRows& A, std::size_t first, std::size_t last, const float* b, float gain, float* d,
               float* z) {
  for (std::size_t i = first; i < last; ++i) {
    float e[B];
    row_solve(A, i, b + B * i, e);
    for (std::size_t c = 0; c < B; ++c) z[B * i + c] = d[B * i + c] = gain * e[c];
  }
}

void step(const FloatRows& A, std::size_t first, std::size_t last, const float* b, const float* z, float keep,
          float gain, float* d, float* to) {
  for (std::size_t i = first; i < last; ++i) {
    float r[B], e[B];
    row_residual(A, i, b, z, r);
    row_solve(A, i, r, e);
    for (std::size_t c = 0; c < B; ++c) {
      const std::size_t at = B * i + c;
      d[at] = keep * d[at] + gain * e[c];
      to[at] = z[at] + d[at];
    }
  }
}

void rest(const FloatRows& A, std::size_t first, std::size_t last, const float* b, const float* z, float* r) {
  for (std::size_t i = first; i < last; ++i) row_residual(A, i, b, z, r + B * i);
}

// The dispatch macros do not support templates.
void product36(const FloatBlocks& A, std::size_t first, std::size_t last, const float* x, float* y) {
  product<3, 6>(A, first, last, x, y);
}
void product63(const FloatBlocks& A, std::size_t first, std::size_t last, const float* x, float* y) {
  product<6, 3>(A, first, last, x, y);
}
void product66(const FloatBlocks& A, std::size_t first, std::size_t last, const float* x, float* y) {
  product<6, 6>(A, first, last, x, y);
}

}  // namespace prosector::soft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace prosector::soft {

HWY_EXPORT(from_zero);
HWY_EXPORT(step);
HWY_EXPORT(rest);
HWY_EXPORT(product36);
HWY_EXPORT(product63);
HWY_EXPORT(product66);

template <>
void multiply<3, 6>(const FloatBlocks& A, std::size_t first, std::size_t last, const float* x, float* y) {
  HWY_DYNAMIC_DISPATCH(product36)(A, first, last, x, y);
}
template <>
void multiply<6, 3>(const FloatBlocks& A, std::size_t first, std::size_t last, const float* x, float* y) {
  HWY_DYNAMIC_DISPATCH(product63)(A, first, last, x, y);
}
template <>
void multiply<6, 6>(const FloatBlocks& A, std::size_t first, std::size_t last, const float* x, float* y) {
  HWY_DYNAMIC_DISPATCH(product66)(A, first, last, x, y);
}

void smooth_from_zero(const FloatRows& A, std::size_t first, std::size_t last, const float* b, float gain,
                      float* d, float* z) {
  HWY_DYNAMIC_DISPATCH(from_zero)(A, first, last, b, gain, d, z);
}
void smooth(const FloatRows& A, std::size_t first, std::size_t last, const float* b, const float* z,
            float keep, float gain, float* d, float* to) {
  HWY_DYNAMIC_DISPATCH(step)(A, first, last, b, z, keep, gain, d, to);
}
void residual(const FloatRows& A, std::size_t first, std::size_t last, const float* b, const float* z,
              float* r) {
  HWY_DYNAMIC_DISPATCH(rest)(A, first, last, b, z, r);
}

}  // namespace prosector::soft
#endif
