// Polar decomposition of polar.h on registers of elements. Included once per instruction set, see
// lane_math.h.

#if defined(PROSECTOR_LANE_POLAR_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PROSECTOR_LANE_POLAR_H
#undef PROSECTOR_LANE_POLAR_H
#else
#define PROSECTOR_LANE_POLAR_H
#endif

#include "server/physics/mechanics/soft/simd/lane_math.h"

HWY_BEFORE_NAMESPACE();
namespace prosector::soft::HWY_NAMESPACE {

struct Quaternion {
  V w;
  Vector v;
};

HWY_INLINE Quaternion normalized(const Quaternion& q) {
  const V s = number(1) / hn::Sqrt(q.w * q.w + dot(q.v, q.v));
  return {s * q.w, s * q.v};
}

/// Returns the 3×3 rotation matrices of the unit quaternions q, one per SIMD lane.
HWY_INLINE Matrix rotation(const Quaternion& q) {
  const V one = number(1);
  const Vector t = q.v + q.v;
  const V xx = t.x * q.v.x, yy = t.y * q.v.y, zz = t.z * q.v.z, xy = t.x * q.v.y, xz = t.x * q.v.z,
          yz = t.y * q.v.z, wx = t.x * q.w, wy = t.y * q.w, wz = t.z * q.w;
  return {{one - (yy + zz), xy + wz, xz - wy},
          {xy - wz, one - (xx + zz), yz + wx},
          {xz + wy, yz - wx, one - (xx + yy)}};
}

/// Returns the largest root of the characteristic quartic of Horn's 4×4 matrix of F, for ‖F‖ = 1, in each
/// SIMD lane. Accurate to half the digits; polished() doubles their number. `gap`: receives the derivative at
/// the root, which is near 0 if the rotation is not unique. A lane that has converged does not change.
HWY_INLINE V largest_root(const Matrix& F, V& gap) {
  const Vector bc = cross(F.b, F.c), ca = cross(F.c, F.a), ab = cross(F.a, F.b);
  const V one = number(1), two = number(2), four = number(4);
  const V c1 = number(-8) * dot(F.a, bc), c0 = one - four * (dot(bc, bc) + dot(ca, ca) + dot(ab, ab));
  V x = number(1.7320508075688772);
  gap = zero();
  M active = x > zero();
  for (int i = 0; i < 30 && !hn::AllFalse(D(), active); ++i) {
    const V xx = x * x;
    gap = hn::IfThenElse(active, four * x * (xx - one) + c1, gap);
    active = hn::And(active, gap > zero());
    const V dx = (((xx - two) * xx + c1 * x) + c0) / gap;
    x = hn::IfThenElse(active, x - dx, x);
    active = hn::And(active, hn::Abs(dx) > number(1e-9));
  }
  return x;
}

/// Returns the unit eigenvector of Horn's symmetric 4×4 matrix of F for the eigenvalue `root`, in each SIMD
/// lane: the quaternion of the rotation closest to F. It is the column of the adjugate with the largest
/// diagonal entry.
HWY_INLINE Quaternion null_vector(const Matrix& F, V root) {
  const V m00 = F.a.x + F.b.y + F.c.z - root, m11 = F.a.x - F.b.y - F.c.z - root,
          m22 = F.b.y - F.a.x - F.c.z - root, m33 = F.c.z - F.a.x - F.b.y - root;
  const V m01 = F.b.z - F.c.y, m02 = F.c.x - F.a.z, m03 = F.a.y - F.b.x;
  const V m12 = F.b.x + F.a.y, m13 = F.c.x + F.a.z, m23 = F.c.y + F.b.z;
  // 2×2 minors of rows 2, 3 (a) and of rows 0, 1 (b).
  const V a01 = m02 * m13 - m12 * m03, a02 = m02 * m23 - m22 * m03, a03 = m02 * m33 - m23 * m03,
          a12 = m12 * m23 - m22 * m13, a13 = m12 * m33 - m23 * m13, a23 = m22 * m33 - m23 * m23;
  const V b01 = m00 * m11 - m01 * m01, b02 = m00 * m12 - m02 * m01, b03 = m00 * m13 - m03 * m01,
          b12 = m01 * m12 - m02 * m11, b13 = m01 * m13 - m03 * m11;
  const V d0 = m11 * a23 - m12 * a13 + m13 * a12, d1 = m00 * a23 - m02 * a03 + m03 * a02,
          d2 = m03 * b13 - m13 * b03 + m33 * b01, d3 = m02 * b12 - m12 * b02 + m22 * b01;
  const V e01 = m12 * a03 - m01 * a23 - m13 * a02, e02 = m01 * a13 - m11 * a03 + m13 * a01,
          e03 = m11 * a02 - m01 * a12 - m12 * a01, e12 = m01 * a03 - m00 * a13 - m03 * a01,
          e13 = m00 * a12 - m01 * a02 + m02 * a01, e23 = m12 * b03 - m02 * b13 - m23 * b01;
  Quaternion q = {d0, {e01, e02, e03}};
  V best = hn::Abs(d0);
  const auto consider = [&](V diagonal, V w, V x, V y, V z) HWY_ATTR {
    const M better = hn::Abs(diagonal) > best;
    best = hn::IfThenElse(better, hn::Abs(diagonal), best);
    q.w = hn::IfThenElse(better, w, q.w);
    q.v.x = hn::IfThenElse(better, x, q.v.x);
    q.v.y = hn::IfThenElse(better, y, q.v.y);
    q.v.z = hn::IfThenElse(better, z, q.v.z);
  };
  consider(d1, e01, d1, e12, e13);
  consider(d2, e02, e12, d2, e23);
  consider(d3, e03, e13, e23, d3);
  return normalized(q);
}

/// Performs one Newton step that improves the rotation R of the unit quaternion q, so that RᵀF is symmetric
/// up to rounding. Returns the improved R, in each SIMD lane.
HWY_INLINE Matrix polished(const Quaternion& q, const Matrix& F) {
  const Matrix R = rotation(q), Rt = transposed(R), S = {Rt * F.a, Rt * F.b, Rt * F.c};
  const V half = number(0.5);
  const Vector axial = {S.b.z - S.c.y, S.c.x - S.a.z, S.a.y - S.b.x};
  const V p = S.b.y + S.c.z, r = S.a.x + S.c.z, s = S.a.x + S.b.y;
  const V off_z = half * (S.a.y + S.b.x), off_y = half * (S.a.z + S.c.x), off_x = half * (S.b.z + S.c.y);
  const Matrix A = {{p, zero() - off_z, zero() - off_y},
                    {zero() - off_z, r, zero() - off_x},
                    {zero() - off_y, zero() - off_x, s}};
  const Matrix adjugate = {cross(A.b, A.c), cross(A.c, A.a), cross(A.a, A.b)};
  const Vector v = half / dot(A.a, adjugate.a) * (adjugate * axial);
  return rotation(normalized({q.w - dot(q.v, v), q.v + q.w * v + cross(q.v, v)}));
}

/// Returns the rotation R of the polar decomposition of F in each SIMD lane. `unique`: receives false for
/// lanes in which R is nearly not unique and must be computed by polar() instead.
HWY_INLINE Matrix polar_rotation(const Matrix& F, M& unique) {
  const V s = number(1) / hn::Sqrt(double_dot(F, F));
  const Matrix unit = {s * F.a, s * F.b, s * F.c};
  V gap;
  const V root = largest_root(unit, gap);
  unique = gap > number(1e-3);
  return polished(null_vector(unit, root), unit);
}

}  // namespace prosector::soft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
