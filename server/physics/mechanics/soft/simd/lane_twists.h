// The rotational part of the corotational tangent on registers of elements. Included once per instruction
// set, see lane_math.h.

#if defined(PROSECTOR_LANE_TWISTS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PROSECTOR_LANE_TWISTS_H
#undef PROSECTOR_LANE_TWISTS_H
#else
#define PROSECTOR_LANE_TWISTS_H
#endif

#include "server/physics/mechanics/soft/simd/lane_principal.h"

HWY_BEFORE_NAMESPACE();
namespace prosector::soft::HWY_NAMESPACE {

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
  SymmetricOf<T> S = stretch(F, R);
  const T trace = S.xx + S.yy + S.zz;
  MatrixOf<T> u = R;
  diagonalise(S, u, tiny);
  const T slope = number<T>(2) * (lambda * (trace - number<T>(3)) + pressure - two_mu);
  const auto coefficient = [&](T pair) HWY_ATTR {
    return half * hn::Max(slope / hn::Max(pair, number<T>(least_pair)), zero<T>() - two_mu);
  };
  const VectorOf<T> ca = coefficient(S.yy + S.zz) * u.a, cb = coefficient(S.xx + S.zz) * u.b,
                    cc = coefficient(S.xx + S.yy) * u.c;
  return {u.a.x * ca + u.b.x * cb + u.c.x * cc, u.a.y * ca + u.b.y * cb + u.c.y * cc,
          u.a.z * ca + u.b.z * cb + u.c.z * cc};
}

}  // namespace prosector::soft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
