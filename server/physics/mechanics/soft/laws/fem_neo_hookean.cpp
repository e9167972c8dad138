#include <Eigen/LU>
#include <cmath>

#include "server/physics/mechanics/soft/laws/fem_laws.h"
#include "server/physics/mechanics/soft/laws/flattened_matrix.h"
#include "server/physics/mechanics/soft/laws/polar.h"
#include "server/physics/mechanics/soft/laws/symmetric_eigen.h"

namespace prosector::soft {
namespace {

/// W = m/2 (I_C − 3) + Λ/2 (J − α)² − b/2 ln((I_C + 1)/4), minus its value at rest; I_C = ‖F‖², J = det F.
/// The constants are Lamé's, re-parameterised so that the law is linear elastic and stress-free at F = I.
struct Parameters {
  double m, volume, alpha, barrier;  // m, Λ and b in Pa
};

Parameters logarithmic(const Lame& c) {
  const double m = 4 * c.mu / 3, volume = c.lambda + 5 * c.mu / 6;
  return {m, volume, 1 + 3 * m / (4 * volume), m};
}

Parameters polynomial(const Lame& c) {
  const double volume = c.lambda + c.mu;
  return {c.mu, volume, 1 + c.mu / volume, 0};
}

Mat3 cofactor(const Mat3& F) {
  Mat3 C;
  C << F.col(1).cross(F.col(2)), F.col(2).cross(F.col(0)), F.col(0).cross(F.col(1));
  return C;
}

class FemNeoHookean final : public ConstitutiveLaw {
 public:
  explicit FemNeoHookean(const Parameters& parameters) : p_(parameters) {}

  void energy_density(std::span<const Mat3> F, std::span<double> W) const override {
    for (std::size_t e = 0; e < F.size(); ++e) {
      const double I = F[e].squaredNorm(), dJ = F[e].determinant() - 1;
      // (J − α)² − (1 − α)², without cancellation.
      W[e] = 0.5 * (p_.m * (I - 3) + p_.volume * dJ * (dJ + 2 * (1 - p_.alpha)));
      if (p_.barrier > 0) W[e] -= 0.5 * p_.barrier * std::log1p((I - 3) / 4);
    }
  }

  void stress(std::span<const Mat3> F, std::span<const double> pressure, std::span<Mat3> P) const override {
    for (std::size_t e = 0; e < F.size(); ++e) {
      const double k = volumetric(F[e].determinant()) + pressure_at(pressure, e);
      P[e] = shear(F[e].squaredNorm()) * F[e] + k * cofactor(F[e]);
    }
  }

  void tangent(std::span<const Mat3> F, std::span<const double> pressure,
               std::span<Mat9> dPdF) const override {
    for (std::size_t e = 0; e < F.size(); ++e) {
      exact_tangent(F[e], pressure_at(pressure, e), dPdF[e]);
      lift_negative(F[e], pressure_at(pressure, e), dPdF[e]);
    }
  }

  void dilatation(std::span<const Mat3> F, std::span<double> theta) const override {
    for (std::size_t e = 0; e < F.size(); ++e) theta[e] = F[e].determinant() - 1;
  }
  void dilatation_gradient(std::span<const Mat3> F, std::span<Mat3> gradient) const override {
    for (std::size_t e = 0; e < F.size(); ++e) gradient[e] = cofactor(F[e]);
  }

 private:
  double shear(double I) const { return p_.m - p_.barrier / (I + 1); }
  double shear_slope(double I) const { return 2 * p_.barrier / ((I + 1) * (I + 1)); }
  double volumetric(double J) const { return p_.volume * (J - p_.alpha); }

  void exact_tangent(const Mat3& F, double pressure, Mat9& H) const {
    const double I = F.squaredNorm();
    H.setIdentity();
    H *= shear(I);
    if (p_.barrier > 0) add_outer(shear_slope(I), vec(F), H);
    add_outer(p_.volume, vec(cofactor(F)), H);
    // ∂(cof F)/∂F: block (k, l) of columns is ±[f]ₓ of the third column.
    const double k = volumetric(F.determinant()) + pressure;
    for (int c = 0; c < 3; ++c) {
      const Mat3 X = k * cross_matrix(F.col(c));
      const int a = (c + 1) % 3, b = (c + 2) % 3;
      H.block<3, 3>(3 * a, 3 * b) -= X;
      H.block<3, 3>(3 * b, 3 * a) += X;
    }
  }

  /// Raises negative eigenvalues to 0. With F = UΣVᵀ the eigenvectors are known (Smith et al., §4.2): twists
  /// and flips with a ± kσ, and three in the span of the scalings.
  void lift_negative(const Mat3& F, double pressure, Mat9& H) const {
    const Polar p = polar(F);
    const SymmetricEigen eigen = symmetric_eigen(p.S);
    const Mat3& V = eigen.vectors;
    const Mat3 U = p.R * V;
    const Vec3& s = eigen.values;
    const double I = s.squaredNorm(), a = shear(I), k = volumetric(s[0] * s[1] * s[2]) + pressure;
    for (int c = 0; c < 3; ++c) {
      const int i = (c + 1) % 3, j = (c + 2) % 3;
      const double twist = a + k * s[c], flip = a - k * s[c];
      if (twist >= 0 && flip >= 0) continue;
      const Mat3 ij = U.col(i) * V.col(j).transpose(), ji = U.col(j) * V.col(i).transpose();
      if (twist < 0) add_outer(-0.5 * twist, vec(ij - ji), H);
      if (flip < 0) add_outer(-0.5 * flip, vec(ij + ji), H);
    }
    lift_scalings(s, a, k, U, V, H);
  }

  void lift_scalings(const Vec3& s, double a, double k, const Mat3& U, const Mat3& V, Mat9& H) const {
    const Vec3 g(s[1] * s[2], s[2] * s[0], s[0] * s[1]);
    Mat3 A = shear_slope(s.squaredNorm()) * s * s.transpose() + p_.volume * g * g.transpose();
    A.diagonal().array() += a;
    for (int c = 0; c < 3; ++c) {
      A((c + 1) % 3, (c + 2) % 3) += k * s[c];
      A((c + 2) % 3, (c + 1) % 3) += k * s[c];
    }
    const double minor = A(0, 0) * A(1, 1) - A(0, 1) * A(1, 0);
    if (A(0, 0) > 0 && minor > 0 && A.determinant() > 0) return;
    const SymmetricEigen scaling = symmetric_eigen(A);
    for (int c = 0; c < 3; ++c) {
      if (scaling.values[c] >= 0) continue;
      const Mat3 Q = U * scaling.vectors.col(c).asDiagonal() * V.transpose();
      add_outer(-scaling.values[c], vec(Q), H);
    }
  }

  Parameters p_;
};

}  // namespace

std::unique_ptr<ConstitutiveLaw> make_fem_neo_hookean(const Material& constants) {
  return std::make_unique<FemNeoHookean>(logarithmic(constants.lame));
}

std::unique_ptr<ConstitutiveLaw> make_fem_neo_hookean_polynomial(const Material& constants) {
  return std::make_unique<FemNeoHookean>(polynomial(constants.lame));
}

std::unique_ptr<ConstitutiveLaw> make_volume_law(const Material& constants) {
  return std::make_unique<FemNeoHookean>(Parameters{0, constants.lame.lambda, 1, 0});
}

}  // namespace prosector::soft
