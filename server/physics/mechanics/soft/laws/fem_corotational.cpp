#include <algorithm>

#include "server/physics/mechanics/soft/laws/fem_laws.h"
#include "server/physics/mechanics/soft/laws/flattened_matrix.h"
#include "server/physics/mechanics/soft/laws/polar.h"
#include "server/physics/mechanics/soft/laws/symmetric_eigen.h"

namespace prosector::soft {
namespace {

// With R's derivative along the twists T_k = R[v_k]ₓ/√2 (v_k: principal directions of S, σᵢ + σⱼ the other
// two stretches) the tangent is
//   2μ I + λ RRᵀ + Σ_k c_k T_k T_kᵀ,  c_k = 2(λ tr(S − I) + p − 2μ)/(σᵢ + σⱼ).
// Since R is orthogonal to every T_k, the eigenvalues on the twists are 2μ + c_k. Clamping c_k at −2μ is the
// exact projection.
class FemCorotational final : public ConstitutiveLaw {
 public:
  explicit FemCorotational(const Lame& constants) : lambda_(constants.lambda), mu_(constants.mu) {}

  void energy_density(std::span<const Mat3> F, std::span<double> W) const override {
    for (std::size_t e = 0; e < F.size(); ++e) {
      const Polar p = polar(F[e]);
      const double volume = p.S.trace() - 3;
      W[e] = mu_ * (F[e] - p.R).squaredNorm() + 0.5 * lambda_ * volume * volume;
    }
  }

  void stress(std::span<const Mat3> F, std::span<const double> pressure, std::span<Mat3> P) const override {
    for (std::size_t e = 0; e < F.size(); ++e) {
      const Polar p = polar(F[e]);
      P[e] = 2 * mu_ * (F[e] - p.R) + (lambda_ * (p.S.trace() - 3) + pressure_at(pressure, e)) * p.R;
    }
  }

  void tangent(std::span<const Mat3> F, std::span<const double> pressure,
               std::span<Mat9> dPdF) const override {
    for (std::size_t e = 0; e < F.size(); ++e) {
      const Polar p = polar(F[e]);
      Mat9& H = dPdF[e];
      H.setIdentity();
      H *= 2 * mu_;
      add_outer(lambda_, vec(p.R), H);
      add_twists(p, pressure_at(pressure, e), H);
    }
  }

  void dilatation(std::span<const Mat3> F, std::span<double> theta) const override {
    for (std::size_t e = 0; e < F.size(); ++e) theta[e] = polar(F[e]).S.trace() - 3;
  }
  void dilatation_gradient(std::span<const Mat3> F, std::span<Mat3> gradient) const override {
    for (std::size_t e = 0; e < F.size(); ++e) gradient[e] = polar(F[e]).R;
  }

 private:
  void add_twists(const Polar& p, double pressure, Mat9& H) const {
    const double slope = 2 * (lambda_ * (p.S.trace() - 3) + pressure - 2 * mu_);
    const SymmetricEigen eigen = symmetric_eigen(p.S);
    for (int k = 0; k < 3; ++k) {
      const double pair = eigen.values[(k + 1) % 3] + eigen.values[(k + 2) % 3];
      const double c = std::max(slope / std::max(pair, least_corotational_pair), -2 * mu_);
      add_outer(0.5 * c, vec(p.R * cross_matrix(eigen.vectors.col(k))), H);
    }
  }

  double lambda_, mu_;
};

}  // namespace

std::unique_ptr<ConstitutiveLaw> make_fem_corotational(const Material& constants) {
  return std::make_unique<FemCorotational>(constants.lame);
}

}  // namespace prosector::soft
