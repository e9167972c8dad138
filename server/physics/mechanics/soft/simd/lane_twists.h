// The rotational part of the corotational tangent on registers of elements. Included once per instruction
// set, see lane_math.h.

#if defined(PROSECTOR_LANE_TWISTS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PROSECTOR_LANE_TWISTS_H
#undef PROSECTOR_LANE_TWISTS_H
#else
#define PROSECTOR_LANE_TWISTS_H
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

/// Computes ½C = ½ Σ c_k u_k u_kᵀ in each SIMD lane: the rotational part of the corotational tangent. Here
/// c_k = max(slope/max(σᵢ + σⱼ, least_pair), −2μ), with slope = 2(λ tr(S − I) + p − 2μ) and the principal
/// stretches σ of F = R·S. The bound −2μ makes the tangent positive semidefinite. The directions u_k = R·v_k
/// result from cyclic Jacobi rotations of S (symmetric_eigen.h), started with R's columns. `tiny`: squared
/// off-diagonal part of S, relative, at which the rotations end. The directions need only the accuracy of
/// Newton's matrix. Since they are orthonormal, the projection is exact anyway.
template <class T>
HWY_INLINE MatrixOf<T> half_twists(T lambda, T two_mu, T pressure, double least_pair, double tiny,
                                   const MatrixOf<T>& F, const MatrixOf<T>& R) {
  const T half = number<T>(0.5);
  T s00 = dot(R.a, F.a), s11 = dot(R.b, F.b), s22 = dot(R.c, F.c);
  T s01 = half * (dot(R.a, F.b) + dot(R.b, F.a)), s02 = half * (dot(R.a, F.c) + dot(R.c, F.a)),
    s12 = half * (dot(R.b, F.c) + dot(R.c, F.b));
  const T trace = s00 + s11 + s22;
  const T small = number<T>(tiny) * (s00 * s00 + s11 * s11 + s22 * s22);
  MatrixOf<T> u = R;
  for (int sweep = 0; sweep < 12; ++sweep) {
    const auto active = s01 * s01 + s02 * s02 + s12 * s12 > small;
    if (hn::AllFalse(hn::DFromV<T>(), active)) break;
    rotate(active, s00, s11, s01, s02, s12, u.a, u.b);
    rotate(active, s00, s22, s02, s01, s12, u.a, u.c);
    rotate(active, s11, s22, s12, s01, s02, u.b, u.c);
  }
  const T slope = number<T>(2) * (lambda * (trace - number<T>(3)) + pressure - two_mu);
  const auto coefficient = [&](T pair) HWY_ATTR {
    return half * hn::Max(slope / hn::Max(pair, number<T>(least_pair)), zero<T>() - two_mu);
  };
  const VectorOf<T> ca = coefficient(s11 + s22) * u.a, cb = coefficient(s00 + s22) * u.b,
                    cc = coefficient(s00 + s11) * u.c;
  return {u.a.x * ca + u.b.x * cb + u.c.x * cc, u.a.y * ca + u.b.y * cb + u.c.y * cc,
          u.a.z * ca + u.b.z * cb + u.c.z * cc};
}

}  // namespace prosector::soft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
