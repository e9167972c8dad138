#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "server/physics/soft/float_rows.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep; compiles this file once per instruction set

// After foreach_target.h, which includes them again.
#include <hwy/highway.h>

#include "server/physics/soft/float_rows.h"

HWY_BEFORE_NAMESPACE();
namespace prosector::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Four floats.
#if HWY_TARGET == HWY_SCALAR
struct V4 {
  float at[4];
};
HWY_INLINE V4 zero4() {
  return {};
}
HWY_INLINE V4 load4(const float* p) {
  return {{p[0], p[1], p[2], p[3]}};
}
HWY_INLINE V4 multiply_add(float s, const V4& v, V4 sum) {
  for (int k = 0; k < 4; ++k) sum.at[k] += s * v.at[k];
  return sum;
}
HWY_INLINE void store4(const V4& v, float* p) {
  for (int k = 0; k < 4; ++k) p[k] = v.at[k];
}
#else
using Four = hn::Full128<float>;
using V4 = hn::Vec<Four>;
HWY_INLINE V4 zero4() {
  return hn::Zero(Four());
}
HWY_INLINE V4 load4(const float* p) {
  return hn::LoadU(Four(), p);
}
HWY_INLINE V4 multiply_add(float s, V4 v, V4 sum) {
  return hn::MulAdd(hn::Set(Four(), s), v, sum);
}
HWY_INLINE void store4(V4 v, float* p) {
  hn::StoreU(v, Four(), p);
}
#endif

/// B floats: the first four and, where there are six, the last four.
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
  /// this + s·v
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

/// Two sums at once, so that one need not wait for the other.
template <int R, int C>
HWY_INLINE void row_product(const FloatBlocks& A, std::size_t i, const float* x, float* y) {
  Column<R> even = Column<R>::zero(), odd = even;
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
  for (std::size_t i = first; i < last; ++i) row_product<R, C>(A, i, x, y + R * i);
}

template <int B>
HWY_INLINE void row_residual(const FloatRows& A, std::size_t i, const float* b, const float* z, float* r) {
  float product[B];
  row_product<B, B>(A.blocks, i, z, product);
  for (std::size_t c = 0; c < B; ++c) r[c] = b[B * i + c] - product[c];
}

template <int B>
HWY_INLINE void row_solve(const FloatRows& A, std::size_t i, const float* r, float* out) {
  block_times<B, B>(A.inverse + B * B * i, r, Column<B>::zero()).store(out);
}

template <int B>
void from_zero(const FloatRows& A, std::size_t first, std::size_t last, const float* b, float gain, float* d,
               float* z) {
  for (std::size_t i = first; i < last; ++i) {
    float e[B];
    row_solve<B>(A, i, b + B * i, e);
    for (std::size_t c = 0; c < B; ++c) z[B * i + c] = d[B * i + c] = gain * e[c];
  }
}

template <int B>
void step(const FloatRows& A, std::size_t first, std::size_t last, const float* b, const float* z, float keep,
          float gain, float* d, float* to) {
  for (std::size_t i = first; i < last; ++i) {
    float r[B], e[B];
    row_residual<B>(A, i, b, z, r);
    row_solve<B>(A, i, r, e);
    for (std::size_t c = 0; c < B; ++c) {
      const std::size_t at = B * i + c;
      d[at] = keep * d[at] + gain * e[c];
      to[at] = z[at] + d[at];
    }
  }
}

template <int B>
void rest(const FloatRows& A, std::size_t first, std::size_t last, const float* b, const float* z, float* r) {
  for (std::size_t i = first; i < last; ++i) row_residual<B>(A, i, b, z, r + B * i);
}

#if HWY_MAX_BYTES >= 32
using D4 = hn::FixedTag<double, 4>;
using Sum = hn::Vec<D4>;
HWY_INLINE Sum no_sum() {
  return hn::Zero(D4());
}
HWY_INLINE Sum block_times(const float* block, const double* x, Sum sum) {
  for (int c = 0; c < 3; ++c)
    sum = hn::MulAdd(hn::PromoteTo(D4(), load4(block + 3 * c)), hn::Set(D4(), x[c]), sum);
  return sum;
}
HWY_INLINE void store(Sum even, Sum odd, double* y) {
  double all[4];
  hn::StoreU(even + odd, D4(), all);
  for (int k = 0; k < 3; ++k) y[k] = all[k];
}
#else
struct Sum {
  double at[3];
};
HWY_INLINE Sum no_sum() {
  return {};
}
HWY_INLINE Sum block_times(const float* block, const double* x, Sum sum) {
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) sum.at[r] += static_cast<double>(block[3 * c + r]) * x[c];
  return sum;
}
HWY_INLINE void store(const Sum& even, const Sum& odd, double* y) {
  for (int k = 0; k < 3; ++k) y[k] = even.at[k] + odd.at[k];
}
#endif

void product_double(const FloatBlocks& A, std::size_t first, std::size_t last, const double* x, double* y) {
  for (std::size_t i = first; i < last; ++i) {
    Sum even = no_sum(), odd = even;
    std::size_t k = A.begin[i];
    for (; k + 1 < A.begin[i + 1]; k += 2) {
      even = block_times(A.value + 9 * k, x + 3 * std::size_t{A.column[k]}, even);
      odd = block_times(A.value + 9 * (k + 1), x + 3 * std::size_t{A.column[k + 1]}, odd);
    }
    if (k < A.begin[i + 1]) even = block_times(A.value + 9 * k, x + 3 * std::size_t{A.column[k]}, even);
    store(even, odd, y + 3 * i);
  }
}

// Dispatch takes no templates.
#define PROSECTOR_FLOAT_ROWS(B)                                                                          \
  void from_zero##B(const FloatRows& A, std::size_t first, std::size_t last, const float* b, float gain, \
                    float* d, float* z) {                                                                \
    from_zero<B>(A, first, last, b, gain, d, z);                                                         \
  }                                                                                                      \
  void step##B(const FloatRows& A, std::size_t first, std::size_t last, const float* b, const float* z,  \
               float keep, float gain, float* d, float* to) {                                            \
    step<B>(A, first, last, b, z, keep, gain, d, to);                                                    \
  }                                                                                                      \
  void rest##B(const FloatRows& A, std::size_t first, std::size_t last, const float* b, const float* z,  \
               float* r) {                                                                               \
    rest<B>(A, first, last, b, z, r);                                                                    \
  }
PROSECTOR_FLOAT_ROWS(3)
PROSECTOR_FLOAT_ROWS(6)
#undef PROSECTOR_FLOAT_ROWS

void product36(const FloatBlocks& A, std::size_t first, std::size_t last, const float* x, float* y) {
  product<3, 6>(A, first, last, x, y);
}
void product63(const FloatBlocks& A, std::size_t first, std::size_t last, const float* x, float* y) {
  product<6, 3>(A, first, last, x, y);
}
void product66(const FloatBlocks& A, std::size_t first, std::size_t last, const float* x, float* y) {
  product<6, 6>(A, first, last, x, y);
}

}  // namespace prosector::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace prosector {

HWY_EXPORT(from_zero3);
HWY_EXPORT(from_zero6);
HWY_EXPORT(step3);
HWY_EXPORT(step6);
HWY_EXPORT(rest3);
HWY_EXPORT(rest6);
HWY_EXPORT(product_double);
HWY_EXPORT(product36);
HWY_EXPORT(product63);
HWY_EXPORT(product66);

void multiply(const FloatBlocks& A, std::size_t first, std::size_t last, const double* x, double* y) {
  HWY_DYNAMIC_DISPATCH(product_double)(A, first, last, x, y);
}
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

template <>
void smooth_from_zero<3>(const FloatRows& A, std::size_t first, std::size_t last, const float* b, float gain,
                         float* d, float* z) {
  HWY_DYNAMIC_DISPATCH(from_zero3)(A, first, last, b, gain, d, z);
}
template <>
void smooth_from_zero<6>(const FloatRows& A, std::size_t first, std::size_t last, const float* b, float gain,
                         float* d, float* z) {
  HWY_DYNAMIC_DISPATCH(from_zero6)(A, first, last, b, gain, d, z);
}
template <>
void smooth<3>(const FloatRows& A, std::size_t first, std::size_t last, const float* b, const float* z,
               float keep, float gain, float* d, float* to) {
  HWY_DYNAMIC_DISPATCH(step3)(A, first, last, b, z, keep, gain, d, to);
}
template <>
void smooth<6>(const FloatRows& A, std::size_t first, std::size_t last, const float* b, const float* z,
               float keep, float gain, float* d, float* to) {
  HWY_DYNAMIC_DISPATCH(step6)(A, first, last, b, z, keep, gain, d, to);
}
template <>
void residual<3>(const FloatRows& A, std::size_t first, std::size_t last, const float* b, const float* z,
                 float* r) {
  HWY_DYNAMIC_DISPATCH(rest3)(A, first, last, b, z, r);
}
template <>
void residual<6>(const FloatRows& A, std::size_t first, std::size_t last, const float* b, const float* z,
                 float* r) {
  HWY_DYNAMIC_DISPATCH(rest6)(A, first, last, b, z, r);
}

}  // namespace prosector
#endif
