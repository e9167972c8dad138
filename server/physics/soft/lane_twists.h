// The rotational part of the corotational tangent on registers of elements. Included once per instruction
// set, see lane_math.h.

#if defined(PROSECTOR_LANE_TWISTS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PROSECTOR_LANE_TWISTS_H
#undef PROSECTOR_LANE_TWISTS_H
#else
#define PROSECTOR_LANE_TWISTS_H
#endif

#include "server/physics/soft/lane_math.h"

HWY_BEFORE_NAMESPACE();
namespace prosector::HWY_NAMESPACE {

/// Annihilates a_pq by turning the columns p, q; lanes that are not `active` stay as they are.
HWY_INLINE void rotate(M active, V& a_pp, V& a_qq, V& a_pq, V& a_rp, V& a_rq, Vector& u_p, Vector& u_q) {
  const V one = number(1), twice = a_pq + a_pq, difference = a_qq - a_pp;
  const V size = hn::Abs(difference) + hn::Sqrt(difference * difference + twice * twice);
  const V signed_twice = hn::IfThenElse(difference < zero(), zero() - twice, twice);
  const V t = hn::IfThenElseZero(hn::And(active, size > zero()), signed_twice / size);
  const V c = one / hn::Sqrt(t * t + one), s = t * c;
  a_pp = a_pp - t * a_pq;
  a_qq = a_qq + t * a_pq;
  a_pq = hn::IfThenElse(active, zero(), a_pq);
  const V rp = a_rp;
  a_rp = c * rp - s * a_rq;
  a_rq = s * rp + c * a_rq;
  const Vector p = u_p;
  u_p = c * p - s * u_q;
  u_q = s * p + c * u_q;
}

/// ½C = ½ Σ c_k u_k u_kᵀ with c_k = max(slope/max(σᵢ + σⱼ, least_pair), −2μ), slope = 2(λ tr(S − I) + p −
/// 2μ): cyclic Jacobi on S, see symmetric_eigen.h, whose vectors start as R's columns and so become u_k =
/// R·v_k. They need to be exact only as far as Newton needs its matrix; that they are orthonormal keeps the
/// projection exact.
HWY_INLINE Matrix half_twists(V lambda, V two_mu, V pressure, double least_pair, const Matrix& F,
                              const Matrix& R) {
  const V half = number(0.5);
  V s00 = dot(R.a, F.a), s11 = dot(R.b, F.b), s22 = dot(R.c, F.c);
  V s01 = half * (dot(R.a, F.b) + dot(R.b, F.a)), s02 = half * (dot(R.a, F.c) + dot(R.c, F.a)),
    s12 = half * (dot(R.b, F.c) + dot(R.c, F.b));
  const V trace = s00 + s11 + s22;
  const V tiny = number(1e-20) * (s00 * s00 + s11 * s11 + s22 * s22);
  Matrix u = R;
  for (int sweep = 0; sweep < 12; ++sweep) {
    const M active = s01 * s01 + s02 * s02 + s12 * s12 > tiny;
    if (hn::AllFalse(D(), active)) break;
    rotate(active, s00, s11, s01, s02, s12, u.a, u.b);
    rotate(active, s00, s22, s02, s01, s12, u.a, u.c);
    rotate(active, s11, s22, s12, s01, s02, u.b, u.c);
  }
  const V slope = number(2) * (lambda * (trace - number(3)) + pressure - two_mu);
  const auto coefficient = [&](V pair) HWY_ATTR {
    return half * hn::Max(slope / hn::Max(pair, number(least_pair)), zero() - two_mu);
  };
  const Vector ca = coefficient(s11 + s22) * u.a, cb = coefficient(s00 + s22) * u.b,
               cc = coefficient(s00 + s11) * u.c;
  return {u.a.x * ca + u.b.x * cb + u.c.x * cc, u.a.y * ca + u.b.y * cb + u.c.y * cc,
          u.a.z * ca + u.b.z * cb + u.c.z * cc};
}

}  // namespace prosector::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
