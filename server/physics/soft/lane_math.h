// Vectors and matrices whose entries are SIMD registers. Compiled once per instruction set: Highway's
// foreach_target.h includes it again for each, so it has a guard that toggles instead of #pragma once.

#if defined(PROSECTOR_LANE_MATH_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PROSECTOR_LANE_MATH_H
#undef PROSECTOR_LANE_MATH_H
#else
#define PROSECTOR_LANE_MATH_H
#endif

#include <hwy/highway.h>

#include <cstddef>

#include "server/physics/soft/element_lanes.h"

HWY_BEFORE_NAMESPACE();
namespace prosector::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<double, 8>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;

struct Vector {
  V x, y, z;
};
/// Columns.
struct Matrix {
  Vector a, b, c;
};

HWY_INLINE V number(double x) {
  return hn::Set(D(), x);
}
HWY_INLINE V zero() {
  return hn::Zero(D());
}
HWY_INLINE V dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
HWY_INLINE Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
HWY_INLINE Vector operator+(const Vector& a, const Vector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
HWY_INLINE Vector operator-(const Vector& a, const Vector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
HWY_INLINE Vector operator*(V s, const Vector& a) {
  return {s * a.x, s * a.y, s * a.z};
}
HWY_INLINE Vector operator*(const Matrix& A, const Vector& v) {
  return v.x * A.a + v.y * A.b + v.z * A.c;
}
HWY_INLINE V double_dot(const Matrix& A, const Matrix& B) {
  return dot(A.a, B.a) + dot(A.b, B.b) + dot(A.c, B.c);
}
HWY_INLINE Matrix transposed(const Matrix& A) {
  return {{A.a.x, A.b.x, A.c.x}, {A.a.y, A.b.y, A.c.y}, {A.a.z, A.b.z, A.c.z}};
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

}  // namespace prosector::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
