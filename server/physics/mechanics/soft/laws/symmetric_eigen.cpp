#include "server/physics/mechanics/soft/laws/symmetric_eigen.h"

#include <cmath>

namespace prosector::soft {
namespace {

/// Annihilates the off-diagonal entry `a_pq`; `a_rp` and `a_rq` are the other two.
void rotate(double& a_pp, double& a_qq, double& a_pq, double& a_rp, double& a_rq, double* v_p, double* v_q) {
  if (a_pq == 0) return;
  const double theta = (a_qq - a_pp) / (2 * a_pq);
  const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::sqrt(theta * theta + 1));
  const double c = 1 / std::sqrt(t * t + 1), s = t * c;
  a_pp -= t * a_pq;
  a_qq += t * a_pq;
  a_pq = 0;
  const double rp = a_rp, rq = a_rq;
  a_rp = c * rp - s * rq;
  a_rq = s * rp + c * rq;
  for (int i = 0; i < 3; ++i) {
    const double p = v_p[i], q = v_q[i];
    v_p[i] = c * p - s * q;
    v_q[i] = s * p + c * q;
  }
}

}  // namespace

SymmetricEigen symmetric_eigen(const Mat3& A) {
  SymmetricEigen out;
  double a00 = A(0, 0), a11 = A(1, 1), a22 = A(2, 2), a01 = A(0, 1), a02 = A(0, 2), a12 = A(1, 2);
  out.vectors.setIdentity();
  double* v = out.vectors.data();
  // Convergence is quadratic: 4 to 6 sweeps reach rounding; the limit is a safeguard.
  const double tiny = 1e-30 * A.squaredNorm();
  for (int sweep = 0; sweep < 12 && a01 * a01 + a02 * a02 + a12 * a12 > tiny; ++sweep) {
    rotate(a00, a11, a01, a02, a12, v, v + 3);
    rotate(a00, a22, a02, a01, a12, v, v + 6);
    rotate(a11, a22, a12, a01, a02, v + 3, v + 6);
  }
  out.values = {a00, a11, a22};
  return out;
}

}  // namespace prosector::soft
