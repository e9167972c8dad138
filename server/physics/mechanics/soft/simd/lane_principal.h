// Principal stretches and directions on registers of elements. Included once per instruction set, see
// lane_math.h.

#if defined(PROSECTOR_LANE_PRINCIPAL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PROSECTOR_LANE_PRINCIPAL_H
#undef PROSECTOR_LANE_PRINCIPAL_H
#else
#define PROSECTOR_LANE_PRINCIPAL_H
#endif

#include "server/physics/mechanics/soft/simd/lane_math.h"

HWY_BEFORE_NAMESPACE();
namespace prosector::soft::HWY_NAMESPACE {

/// Performs a Jacobi rotation of columns p and q of a symmetric 3×3 matrix in each SIMD lane, which makes its
/// entry a_pq zero. The third index is r. The eigenvector columns u_p and u_q are rotated too. Lanes that are
/// not `active` do not change.
template <class T, class Mask>
HWY_INLINE void rotate(Mask active, T& a_pp, T& a_qq, T& a_pq, T& a_rp, T& a_rq, VectorOf<T>& u_p,
                       VectorOf<T>& u_q) {
  const T one = number<T>(1), twice = a_pq + a_pq, difference = a_qq - a_pp;
  const T size = hn::Abs(difference) + hn::Sqrt(difference * difference + twice * twice);
  const T signed_twice = hn::IfThenElse(difference < zero<T>(), zero<T>() - twice, twice);
  const T t = hn::IfThenElseZero(hn::And(active, size > zero<T>()), signed_twice / size);
  const T c = one / hn::Sqrt(t * t + one), s = t * c;
  a_pp = a_pp - t * a_pq;
  a_qq = a_qq + t * a_pq;
  a_pq = hn::IfThenElse(active, zero<T>(), a_pq);
  const T rp = a_rp;
  a_rp = c * rp - s * a_rq;
  a_rq = s * rp + c * a_rq;
  const VectorOf<T> p = u_p;
  u_p = c * p - s * u_q;
  u_q = s * p + c * u_q;
}

/// Symmetric 3×3 matrices, one per SIMD lane.
template <class T>
struct SymmetricOf {
  T xx, yy, zz, xy, xz, yz;
};

/// Diagonalises A by cyclic Jacobi rotations (symmetric_eigen.h) in each SIMD lane. Afterwards A.xx, A.yy and
/// A.zz are its eigenvalues, and each column of `u` is the combination of u's former columns that belongs to
/// one of them. `tiny`: squared off-diagonal part of A, relative to the squared diagonal, at which the
/// rotations end.
template <class T>
HWY_INLINE void diagonalise(SymmetricOf<T>& A, MatrixOf<T>& u, double tiny) {
  const T small = number<T>(tiny) * (A.xx * A.xx + A.yy * A.yy + A.zz * A.zz);
  for (int sweep = 0; sweep < 12; ++sweep) {
    const auto active = A.xy * A.xy + A.xz * A.xz + A.yz * A.yz > small;
    if (hn::AllFalse(hn::DFromV<T>(), active)) break;
    rotate(active, A.xx, A.yy, A.xy, A.xz, A.yz, u.a, u.b);
    rotate(active, A.xx, A.zz, A.xz, A.xy, A.yz, u.a, u.c);
    rotate(active, A.yy, A.zz, A.yz, A.xy, A.xz, u.b, u.c);
  }
}

/// Returns the symmetric part of RᵀF in each SIMD lane: the stretch S of the polar decomposition F = R·S.
template <class T>
HWY_INLINE SymmetricOf<T> stretch(const MatrixOf<T>& F, const MatrixOf<T>& R) {
  const T half = number<T>(0.5);
  return {dot(R.a, F.a),
          dot(R.b, F.b),
          dot(R.c, F.c),
          half * (dot(R.a, F.b) + dot(R.b, F.a)),
          half * (dot(R.a, F.c) + dot(R.c, F.a)),
          half * (dot(R.b, F.c) + dot(R.c, F.b))};
}

}  // namespace prosector::soft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
