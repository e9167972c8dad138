#include <algorithm>

#include "server/physics/mechanics/soft/laws/fem_laws.h"
#include "server/physics/mechanics/soft/laws/flattened_matrix.h"

namespace prosector::soft {
namespace {

/// Neo-Hookean law with fibres: W = W_iso + k/8 ⟨I₄ − 1⟩², I₄ = |Fa|². The fibre's tangent k (Fa⊗a)(Fa⊗a)ᵀ +
/// k/2⟨I₄ − 1⟩ (a aᵀ)⊗I has no negative eigenvalue, so only the isotropic part is projected.
class FemFibers final : public ConstitutiveLaw {
 public:
  explicit FemFibers(const Material& constants)
      : tissue_(make_fem_neo_hookean(constants)), k_(constants.fiber_stiffness), a_(constants.fiber) {}

  void energy_density(std::span<const Mat3> F, std::span<double> W) const override {
    tissue_->energy_density(F, W);
    for (std::size_t e = 0; e < F.size(); ++e) {
      const double taut = stretched(F[e] * a_);
      W[e] += k_ / 8 * taut * taut;
    }
  }

  void stress(std::span<const Mat3> F, std::span<const double> pressure, std::span<Mat3> P) const override {
    tissue_->stress(F, pressure, P);
    for (std::size_t e = 0; e < F.size(); ++e) {
      const Vec3 f = F[e] * a_;
      P[e] += k_ / 2 * stretched(f) * f * a_.transpose();
    }
  }

  void tangent(std::span<const Mat3> F, std::span<const double> pressure,
               std::span<Mat9> dPdF) const override {
    tissue_->tangent(F, pressure, dPdF);
    for (std::size_t e = 0; e < F.size(); ++e) {
      const Vec3 f = F[e] * a_;
      const double taut = stretched(f);
      if (!(taut > 0)) continue;
      add_outer(k_, vec(f * a_.transpose()), dPdF[e]);
      for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i)
          dPdF[e].block<3, 3>(3 * i, 3 * j).diagonal().array() += k_ / 2 * taut * a_[i] * a_[j];
    }
  }

  void dilatation(std::span<const Mat3> F, std::span<double> theta) const override {
    tissue_->dilatation(F, theta);
  }
  void dilatation_gradient(std::span<const Mat3> F, std::span<Mat3> gradient) const override {
    tissue_->dilatation_gradient(F, gradient);
  }

 private:
  /// Returns ⟨I₄ − 1⟩ from f = Fa.
  static double stretched(const Vec3& f) { return std::max(0.0, f.squaredNorm() - 1); }

  std::unique_ptr<ConstitutiveLaw> tissue_;
  double k_;  // Pa
  Vec3 a_;
};

}  // namespace

std::unique_ptr<ConstitutiveLaw> make_fem_fibers(const Material& constants) {
  return std::make_unique<FemFibers>(constants);
}

}  // namespace prosector::soft
