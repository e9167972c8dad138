#include <algorithm>

#include "server/physics/mechanics/soft/laws/fem_laws.h"
#include "server/physics/mechanics/soft/laws/flattened_matrix.h"
#include "server/physics/mechanics/soft/laws/polar.h"
#include "server/physics/mechanics/soft/laws/symmetric_eigen.h"

namespace prosector::soft {
namespace {

class FemStVK final : public ConstitutiveLaw {
 public:
  explicit FemStVK(const Lame& constants) : lambda_(constants.lambda), mu_(constants.mu) {}

  void energy_density(std::span<const Mat3> F, std::span<double> W) const override {
    for (std::size_t e = 0; e < F.size(); ++e) {
      const Mat3 E = green(F[e]);
      W[e] = mu_ * E.squaredNorm() + 0.5 * lambda_ * E.trace() * E.trace();
    }
  }

  void stress(std::span<const Mat3> F, std::span<const double> pressure, std::span<Mat3> P) const override {
    for (std::size_t e = 0; e < F.size(); ++e) {
      const Mat3 E = green(F[e]);
      P[e] = F[e] * (2 * mu_ * E + (lambda_ * E.trace() + pressure_at(pressure, e)) * Mat3::Identity());
    }
  }

  /// Builds the tangent from the eigenvectors common to all isotropic laws (Smith, de Goes & Kim 2019): with
  /// F = UΣVᵀ, twists and flips of each pair of axes, and three scalings.
  void tangent(std::span<const Mat3> F, std::span<const double> pressure,
               std::span<Mat9> dPdF) const override {
    for (std::size_t e = 0; e < F.size(); ++e) {
      const Polar p = polar(F[e]);
      const SymmetricEigen eigen = symmetric_eigen(p.S);
      dPdF[e].setZero();
      const double k = 0.5 * lambda_ * (eigen.values.squaredNorm() - 3) + pressure_at(pressure, e);
      add_scalings(k, eigen.values, p.R * eigen.vectors, eigen.vectors, dPdF[e]);
      add_rotations(k, eigen.values, p.R * eigen.vectors, eigen.vectors, dPdF[e]);
    }
  }

  void dilatation(std::span<const Mat3> F, std::span<double> theta) const override {
    for (std::size_t e = 0; e < F.size(); ++e) theta[e] = green(F[e]).trace();
  }
  void dilatation_gradient(std::span<const Mat3> F, std::span<Mat3> gradient) const override {
    std::copy(F.begin(), F.end(), gradient.begin());
  }

 private:
  static Mat3 green(const Mat3& F) { return 0.5 * (F.transpose() * F - Mat3::Identity()); }

  /// Adds the scalings. `k`: λ tr E plus the external pressure.
  void add_scalings(double k, const Vec3& s, const Mat3& U, const Mat3& V, Mat9& H) const {
    Mat3 A = lambda_ * s * s.transpose();
    A.diagonal().array() += k + mu_ * (3 * s.array().square() - 1);
    const SymmetricEigen scaling = symmetric_eigen(A);
    for (int c = 0; c < 3; ++c) {
      if (!(scaling.values[c] > 0)) continue;
      const Mat3 Q = U * scaling.vectors.col(c).asDiagonal() * V.transpose();
      add_outer(scaling.values[c], vec(Q), H);
    }
  }

  void add_rotations(double k, const Vec3& s, const Mat3& U, const Mat3& V, Mat9& H) const {
    for (int c = 0; c < 3; ++c) {
      const int i = (c + 1) % 3, j = (c + 2) % 3;
      const double squares = s[i] * s[i] + s[j] * s[j] - 1, product = s[i] * s[j];
      const double twist = k + mu_ * (squares - product);
      const double flip = k + mu_ * (squares + product);
      const Mat3 ij = U.col(i) * V.col(j).transpose(), ji = U.col(j) * V.col(i).transpose();
      if (twist > 0) add_outer(0.5 * twist, vec(ij - ji), H);
      if (flip > 0) add_outer(0.5 * flip, vec(ij + ji), H);
    }
  }

  double lambda_, mu_;
};

}  // namespace

std::unique_ptr<ConstitutiveLaw> make_fem_stvk(const Material& constants) {
  return std::make_unique<FemStVK>(constants.lame);
}

}  // namespace prosector::soft
