// Vectors and matrices whose entries are SIMD registers. Compiled once per instruction set: Highway's
// foreach_target.h includes this file again for each, so it has a toggling guard instead of #pragma once.

#if defined(PROSECTOR_LANE_MATH_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PROSECTOR_LANE_MATH_H
#undef PROSECTOR_LANE_MATH_H
#else
#define PROSECTOR_LANE_MATH_H
#endif

#include <hwy/highway.h>

#include <cstddef>

#include "server/physics/mechanics/soft/simd/element_lanes.h"

HWY_BEFORE_NAMESPACE();
namespace prosector::soft::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<double, 8>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;

/// Three-dimensional vectors of several elements, one SIMD register per component. T: a register of doubles,
/// or one of equally many floats.
template <class T>
struct VectorOf {
  T x, y, z;
};
/// 3×3 matrices of several elements, as three columns, with one SIMD register of type T per entry.
template <class T>
struct MatrixOf {
  VectorOf<T> a, b, c;
};
using Vector = VectorOf<V>;
using Matrix = MatrixOf<V>;

template <class T = V>
HWY_INLINE T number(double x) {
  using Tag = hn::DFromV<T>;
  return hn::Set(Tag(), static_cast<hn::TFromD<Tag>>(x));
}
template <class T = V>
HWY_INLINE T zero() {
  return hn::Zero(hn::DFromV<T>());
}
template <class T>
HWY_INLINE T dot(const VectorOf<T>& a, const VectorOf<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
HWY_INLINE VectorOf<T> cross(const VectorOf<T>& a, const VectorOf<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T>
HWY_INLINE VectorOf<T> operator+(const VectorOf<T>& a, const VectorOf<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
HWY_INLINE VectorOf<T> operator-(const VectorOf<T>& a, const VectorOf<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
HWY_INLINE VectorOf<T> operator*(T s, const VectorOf<T>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class T>
HWY_INLINE VectorOf<T> operator*(const MatrixOf<T>& A, const VectorOf<T>& v) {
  return v.x * A.a + v.y * A.b + v.z * A.c;
}
HWY_INLINE V double_dot(const Matrix& A, const Matrix& B) {
  return dot(A.a, B.a) + dot(A.b, B.b) + dot(A.c, B.c);
}
HWY_INLINE Matrix transposed(const Matrix& A) {
  return {{A.a.x, A.b.x, A.c.x}, {A.a.y, A.b.y, A.c.y}, {A.a.z, A.b.z, A.c.z}};
}

/// SIMD register with as many floats as V has doubles. The functions `single` convert registers, vectors and
/// matrices of doubles to it.
using Single = hn::Vec<hn::Rebind<float, D>>;
HWY_INLINE Single single(V x) {
  return hn::DemoteTo(hn::Rebind<float, D>(), x);
}
HWY_INLINE VectorOf<Single> single(const Vector& v) {
  return {single(v.x), single(v.y), single(v.z)};
}
HWY_INLINE MatrixOf<Single> single(const Matrix& A) {
  return {single(A.a), single(A.b), single(A.c)};
}

HWY_INLINE Matrix load(const LaneMatrix& m, std::size_t i) {
  const D d;
  const auto column = [&](std::size_t k) HWY_ATTR {
    return Vector{hn::Load(d, m.at[k] + i), hn::Load(d, m.at[k + 1] + i), hn::Load(d, m.at[k + 2] + i)};
  };
  return {column(0), column(3), column(6)};
}
HWY_INLINE void store(const Matrix& A, LaneMatrix& m, std::size_t i) {
  const D d;
  const auto column = [&](const Vector& v, std::size_t k) HWY_ATTR {
    hn::Store(v.x, d, m.at[k] + i);
    hn::Store(v.y, d, m.at[k + 1] + i);
    hn::Store(v.z, d, m.at[k + 2] + i);
  };
  column(A.a, 0);
  column(A.b, 3);
  column(A.c, 6);
}

}  // namespace prosector::soft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
