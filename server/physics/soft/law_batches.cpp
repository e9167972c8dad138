#include <array>

#include "server/physics/soft/corotational_kernel.h"
#include "server/physics/soft/element_batches.h"

namespace prosector {
namespace {

class LawBatches final : public ElementBatches {
 public:
  LawBatches(std::unique_ptr<ConstitutiveLaw> law, const Lame& constants, const Tet4Elements& elements)
      : ElementBatches(constants, elements), law_(std::move(law)), F_(elements.size()) {}

  bool objective() const override { return law_->objective(); }
  void move(std::size_t batch, const double* x) override {
    deform(batch, x);
    for (std::size_t lane = 0; lane < count(batch); ++lane) {
      Mat3& F = F_[first(batch) + lane];
      for (std::size_t k = 0; k < 9; ++k) F.data()[k] = strain_[batch].F.at[k][lane];
    }
  }

  double energy(std::size_t batch) const override {
    std::array<double, elements_per_batch> W;
    law_->energy_density(gradients(batch), std::span(W.data(), count(batch)));
    double sum = 0;
    for (std::size_t e = 0; e < count(batch); ++e) sum += elements_.volume(first(batch) + e) * W[e];
    return sum;
  }

  void forces(std::size_t batch, std::span<Tet4Elements::Forces> f) const override {
    std::array<Mat3, elements_per_batch> P;
    law_->stress(gradients(batch), std::span(P.data(), f.size()));
    for (std::size_t e = 0; e < f.size(); ++e) elements_.forces(first(batch) + e, P[e], f[e]);
  }

  void stiffness(std::size_t batch, std::span<Tet4Elements::Stiffness> K) const override {
    std::array<Mat9, elements_per_batch> dPdF;
    law_->tangent(gradients(batch), std::span(dPdF.data(), K.size()));
    for (std::size_t e = 0; e < K.size(); ++e) elements_.stiffness(first(batch) + e, dPdF[e], K[e]);
  }

  void warped_stiffness(std::size_t batch, std::span<Tet4Elements::Stiffness> K) const override {
    LaneStrain strain = strain_[batch];
    if (law_->objective()) {
      lane_rotations(strain);
    } else {
      for (std::size_t k = 0; k < 9; ++k) {
        for (double& entry : strain.R.at[k]) entry = k % 4 == 0 ? 1 : 0;
      }
    }
    lane_warped_stiffness(lame_, rest_[batch], strain.R, K);
  }

 private:
  std::span<const Mat3> gradients(std::size_t batch) const {
    return std::span(F_).subspan(first(batch), count(batch));
  }

  std::unique_ptr<ConstitutiveLaw> law_;
  std::vector<Mat3> F_;
};

}  // namespace

std::unique_ptr<ElementBatches> make_law_batches(std::unique_ptr<ConstitutiveLaw> law, const Lame& constants,
                                                 const Tet4Elements& elements) {
  return std::make_unique<LawBatches>(std::move(law), constants, elements);
}

}  // namespace prosector
