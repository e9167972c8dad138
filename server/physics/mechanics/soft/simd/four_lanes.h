// Four floats (V4) or four doubles (W4) in a register, with a scalar fallback. Compiled once per instruction
// set, see lane_math.h.

#if defined(PROSECTOR_FOUR_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PROSECTOR_FOUR_H
#undef PROSECTOR_FOUR_H
#else
#define PROSECTOR_FOUR_H
#endif

#include <hwy/highway.h>

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace prosector::soft::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

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
HWY_INLINE V4 multiply_add(const V4& a, const V4& b, V4 sum) {
  for (int k = 0; k < 4; ++k) sum.at[k] += a.at[k] * b.at[k];
  return sum;
}
HWY_INLINE V4 scaled(float s, const V4& v) {
  return multiply_add(s, v, zero4());
}
HWY_INLINE V4 added(V4 a, const V4& b) {
  for (int k = 0; k < 4; ++k) a.at[k] += b.at[k];
  return a;
}
HWY_INLINE V4 cross4(const V4& a, const V4& b) {
  return {{a.at[1] * b.at[2] - a.at[2] * b.at[1], a.at[2] * b.at[0] - a.at[0] * b.at[2],
           a.at[0] * b.at[1] - a.at[1] * b.at[0], 0}};
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
HWY_INLINE V4 multiply_add(V4 a, V4 b, V4 sum) {
  return hn::MulAdd(a, b, sum);
}
HWY_INLINE V4 scaled(float s, V4 v) {
  return hn::Set(Four(), s) * v;
}
HWY_INLINE V4 added(V4 a, V4 b) {
  return a + b;
}
/// Returns the vector (y, z, x) for v = (x, y, z), a cyclic permutation. The fourth entry of the result is
/// undefined.
HWY_INLINE V4 rotated4(V4 v) {
  alignas(16) static constexpr std::int32_t from[4] = {1, 2, 0, 3};
  return hn::TableLookupLanes(v, hn::SetTableIndices(Four(), from));
}
/// Returns the cross product a × b of the first three entries. The fourth entry of the result is undefined.
HWY_INLINE V4 cross4(V4 a, V4 b) {
  return rotated4(hn::MulSub(a, rotated4(b), rotated4(a) * b));
}
HWY_INLINE void store4(V4 v, float* p) {
  hn::StoreU(v, Four(), p);
}
#endif

#if HWY_MAX_BYTES >= 32
using FourDoubles = hn::FixedTag<double, 4>;
using W4 = hn::Vec<FourDoubles>;
HWY_INLINE W4 wide_zero() {
  return hn::Zero(FourDoubles());
}
HWY_INLINE W4 wide(const float* p) {
  return hn::PromoteTo(FourDoubles(), load4(p));
}
HWY_INLINE W4 wide(const double* p) {
  return hn::LoadU(FourDoubles(), p);
}
HWY_INLINE W4 multiply_add(W4 a, W4 b, W4 sum) {
  return hn::MulAdd(a, b, sum);
}
HWY_INLINE W4 multiply_add(double s, W4 v, W4 sum) {
  return hn::MulAdd(hn::Set(FourDoubles(), s), v, sum);
}
HWY_INLINE void store(W4 v, double* p) {
  hn::StoreU(v, FourDoubles(), p);
}
/// Adds the transpose of a 3×3 matrix to it: A += Aᵀ. `A`: its three columns; their fourth entries are
/// ignored.
HWY_INLINE void add_transposed(W4* A) {
  const FourDoubles d;
  const W4 even = hn::InterleaveLower(d, A[0], A[1]),
           odd = hn::InterleaveUpper(d, A[0], A[1]);  // a0 b0 a2 b2
  const W4 even2 = hn::InterleaveLower(d, A[2], A[2]), odd2 = hn::InterleaveUpper(d, A[2], A[2]);
  A[0] = A[0] + hn::ConcatLowerLower(d, even2, even);
  A[1] = A[1] + hn::ConcatLowerLower(d, odd2, odd);
  A[2] = A[2] + hn::ConcatUpperUpper(d, even2, even);
}
#else
struct W4 {
  double at[4];
};
HWY_INLINE W4 wide_zero() {
  return {};
}
HWY_INLINE W4 wide(const float* p) {
  W4 v;
  for (int k = 0; k < 4; ++k) v.at[k] = static_cast<double>(p[k]);
  return v;
}
HWY_INLINE W4 wide(const double* p) {
  return {{p[0], p[1], p[2], p[3]}};
}
HWY_INLINE W4 multiply_add(const W4& a, const W4& b, W4 sum) {
  for (int k = 0; k < 4; ++k) sum.at[k] += a.at[k] * b.at[k];
  return sum;
}
HWY_INLINE W4 multiply_add(double s, const W4& v, W4 sum) {
  for (int k = 0; k < 4; ++k) sum.at[k] += s * v.at[k];
  return sum;
}
HWY_INLINE void store(const W4& v, double* p) {
  for (int k = 0; k < 4; ++k) p[k] = v.at[k];
}
HWY_INLINE void add_transposed(W4* A) {
  const W4 a = A[0], b = A[1], c = A[2];
  for (int k = 0; k < 3; ++k) {
    A[k].at[0] += a.at[k];
    A[k].at[1] += b.at[k];
    A[k].at[2] += c.at[k];
  }
}
#endif
/// Returns the sum of the first three of the four entries of v.
HWY_INLINE double sum_of_three(const W4& v) {
  double entry[4];
  store(v, entry);
  return entry[0] + entry[1] + entry[2];
}

}  // namespace prosector::soft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
