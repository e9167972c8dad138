#include "server/physics/mechanics/soft/laws/polar.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>

namespace prosector::soft {
namespace {

using Vec4 = Eigen::Vector4d;
using Mat4 = Eigen::Matrix4d;

/// Returns the matrix K of qᵀKq = tr(R(q)ᵀF) for unit quaternions q = (w, x, y, z).
Mat4 horn(const Mat3& F) {
  Mat4 K;
  K(0, 0) = F(0, 0) + F(1, 1) + F(2, 2);
  K(1, 1) = F(0, 0) - F(1, 1) - F(2, 2);
  K(2, 2) = F(1, 1) - F(0, 0) - F(2, 2);
  K(3, 3) = F(2, 2) - F(0, 0) - F(1, 1);
  K(0, 1) = K(1, 0) = F(2, 1) - F(1, 2);
  K(0, 2) = K(2, 0) = F(0, 2) - F(2, 0);
  K(0, 3) = K(3, 0) = F(1, 0) - F(0, 1);
  K(1, 2) = K(2, 1) = F(0, 1) + F(1, 0);
  K(1, 3) = K(3, 1) = F(0, 2) + F(2, 0);
  K(2, 3) = K(3, 2) = F(1, 2) + F(2, 1);
  return K;
}

/// Returns the largest root of Horn's characteristic quartic, for ‖F‖ = 1; converges monotonically from
/// above. `gap`: the derivative at the root, ∏(λ − λᵢ) over the other roots; 0 if the rotation is not unique.
double largest_root(const Mat3& F, double& gap) {
  const double det = F.determinant();
  const double cofactors = F.col(0).cross(F.col(1)).squaredNorm() + F.col(1).cross(F.col(2)).squaredNorm() +
                           F.col(2).cross(F.col(0)).squaredNorm();
  const double c1 = -8 * det, c0 = 1 - 4 * cofactors;
  double x = std::sqrt(3.0);
  for (int i = 0; i < 30; ++i) {
    const double xx = x * x;
    const double value = (xx - 2) * xx + c1 * x + c0;
    gap = 4 * x * (xx - 1) + c1;
    if (!(gap > 0)) break;
    const double dx = value / gap;
    x -= dx;
    if (std::abs(dx) < 1e-15) break;
  }
  return x;
}

/// Returns the null vector of the symmetric, rank-3 M: the column of its adjugate with the largest diagonal
/// entry.
Vec4 null_vector(const Mat4& M) {
  // 2×2 minors of rows 2, 3, and of rows 0, 1.
  const auto minor = [&](int r, int c, int d) { return M(r, c) * M(r + 1, d) - M(r, d) * M(r + 1, c); };
  const double a01 = minor(2, 0, 1), a02 = minor(2, 0, 2), a03 = minor(2, 0, 3), a12 = minor(2, 1, 2),
               a13 = minor(2, 1, 3), a23 = minor(2, 2, 3);
  const double b01 = minor(0, 0, 1), b02 = minor(0, 0, 2), b03 = minor(0, 0, 3), b12 = minor(0, 1, 2),
               b13 = minor(0, 1, 3), b23 = minor(0, 2, 3);
  const Vec4 diagonal(
      M(1, 1) * a23 - M(1, 2) * a13 + M(1, 3) * a12, M(0, 0) * a23 - M(0, 2) * a03 + M(0, 3) * a02,
      M(3, 0) * b13 - M(3, 1) * b03 + M(3, 3) * b01, M(2, 0) * b12 - M(2, 1) * b02 + M(2, 2) * b01);
  int best = 0;
  diagonal.cwiseAbs().maxCoeff(&best);
  switch (best) {
    case 0:
      return {diagonal[0], -(M(1, 0) * a23 - M(1, 2) * a03 + M(1, 3) * a02),
              M(1, 0) * a13 - M(1, 1) * a03 + M(1, 3) * a01,
              -(M(1, 0) * a12 - M(1, 1) * a02 + M(1, 2) * a01)};
    case 1:
      return {-(M(0, 1) * a23 - M(0, 2) * a13 + M(0, 3) * a12), diagonal[1],
              -(M(0, 0) * a13 - M(0, 1) * a03 + M(0, 3) * a01),
              M(0, 0) * a12 - M(0, 1) * a02 + M(0, 2) * a01};
    case 2:
      return {M(3, 1) * b23 - M(3, 2) * b13 + M(3, 3) * b12, -(M(3, 0) * b23 - M(3, 2) * b03 + M(3, 3) * b02),
              diagonal[2], -(M(3, 0) * b12 - M(3, 1) * b02 + M(3, 2) * b01)};
    default:
      return {-(M(2, 1) * b23 - M(2, 2) * b13 + M(2, 3) * b12), M(2, 0) * b23 - M(2, 2) * b03 + M(2, 3) * b02,
              -(M(2, 0) * b13 - M(2, 1) * b03 + M(2, 3) * b01), diagonal[3]};
  }
}

Vec4 largest_eigenvector(const Mat4& K) {
  const Eigen::SelfAdjointEigenSolver<Mat4> eigen(K);
  return eigen.eigenvectors().col(3);
}

Mat3 rotation(const Vec4& q) {
  return Quat(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
}

/// Performs one Newton step towards symmetric RᵀF: the rotation w with (tr(S)I − S)w = axial(RᵀF − FᵀR)/1.
Mat3 polished(const Mat3& R, const Mat3& F) {
  const Mat3 S = R.transpose() * F;
  const Vec3 axial(S(2, 1) - S(1, 2), S(0, 2) - S(2, 0), S(1, 0) - S(0, 1));
  if (axial.cwiseAbs().maxCoeff() < 4e-16) return R;
  const Mat3 A = S.trace() * Mat3::Identity() - 0.5 * (S + S.transpose());
  const Vec3 w = A.inverse() * axial;
  return R * rotation(Vec4(1, w[0] / 2, w[1] / 2, w[2] / 2));
}

}  // namespace

Polar polar(const Mat3& F) {
  const double scale = F.norm();
  if (!(scale > 0) || !std::isfinite(scale)) return {Mat3::Identity(), F};
  const Mat3 unit = F / scale;
  const Mat4 K = horn(unit);
  double gap = 0;
  const double root = largest_root(unit, gap);
  Polar out;
  // gap = 8·(σ₁+σ₂)(σ₁+σ₃)(σ₂+σ₃) is 12.3 at rest.
  if (gap > 1e-3) {
    out.R = polished(rotation(null_vector(K - root * Mat4::Identity())), unit);
  } else {
    out.R = rotation(largest_eigenvector(K));
  }
  const Mat3 S = out.R.transpose() * F;
  out.S = 0.5 * (S + S.transpose());
  return out;
}

}  // namespace prosector::soft
