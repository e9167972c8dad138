#include "server/physics/mechanics/soft/laws/fem_laws.h"

namespace prosector::soft {
namespace {

Mat3 strain(const Mat3& F) {
  return 0.5 * (F + F.transpose()) - Mat3::Identity();
}

class FemLinear final : public ConstitutiveLaw {
 public:
  explicit FemLinear(const Lame& constants) : lambda_(constants.lambda), mu_(constants.mu) {
    tangent_.setZero();
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) {
        tangent_(i + 3 * k, i + 3 * k) += mu_;  // μ(dF + dFᵀ)
        tangent_(i + 3 * k, k + 3 * i) += mu_;
        tangent_(4 * i, 4 * k) += lambda_;  // λ tr(dF) I
      }
    }
  }

  bool objective() const override { return false; }

  void energy_density(std::span<const Mat3> F, std::span<double> W) const override {
    for (std::size_t e = 0; e < F.size(); ++e) {
      const Mat3 eps = strain(F[e]);
      W[e] = mu_ * eps.squaredNorm() + 0.5 * lambda_ * eps.trace() * eps.trace();
    }
  }

  void stress(std::span<const Mat3> F, std::span<const double> pressure, std::span<Mat3> P) const override {
    for (std::size_t e = 0; e < F.size(); ++e) {
      const Mat3 eps = strain(F[e]);
      P[e] = 2 * mu_ * eps + (lambda_ * eps.trace() + pressure_at(pressure, e)) * Mat3::Identity();
    }
  }

  void tangent(std::span<const Mat3> F, std::span<const double>, std::span<Mat9> dPdF) const override {
    for (std::size_t e = 0; e < F.size(); ++e) dPdF[e] = tangent_;
  }

  void dilatation(std::span<const Mat3> F, std::span<double> theta) const override {
    for (std::size_t e = 0; e < F.size(); ++e) theta[e] = F[e].trace() - 3;
  }
  void dilatation_gradient(std::span<const Mat3>, std::span<Mat3> gradient) const override {
    for (Mat3& G : gradient) G.setIdentity();
  }

 private:
  double lambda_, mu_;
  Mat9 tangent_;  // semidefinite for μ ≥ 0, 3λ + 2μ ≥ 0: every ν in (−1, ½)
};

}  // namespace

std::unique_ptr<ConstitutiveLaw> make_fem_linear(const Material& constants) {
  return std::make_unique<FemLinear>(constants.lame);
}

}  // namespace prosector::soft
