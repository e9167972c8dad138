#include <array>

#include "server/physics/soft/corotational_kernel.h"
#include "server/physics/soft/element_batches.h"

namespace prosector {
namespace {

class LawBatches final : public ElementBatches {
 public:
  LawBatches(std::unique_ptr<ConstitutiveLaw> (*make)(const Material&), const Materials& materials,
             const Tet4Elements& elements)
      : ElementBatches(materials, elements), F_(elements.size()) {
    for (const Material& material : materials.kinds) laws_.push_back(make(material));
  }

  bool objective() const override { return laws_.front()->objective(); }
  void move(std::size_t batch, const double* x) override {
    deform(batch, x);
    for (std::size_t lane = 0; lane < count(batch); ++lane) {
      Mat3& F = F_[first(batch) + lane];
      for (std::size_t k = 0; k < 9; ++k) F.data()[k] = strain_[batch].F.at[k][lane];
    }
  }

  double energy(std::size_t batch) const override {
    std::array<double, elements_per_batch> W;
    for_laws(batch, [&](const ConstitutiveLaw& law, auto F, std::size_t at) {
      law.energy_density(F, std::span(&W[at], F.size()));
    });
    double sum = 0;
    for (std::size_t e = 0; e < count(batch); ++e) sum += elements_.volume(first(batch) + e) * W[e];
    return sum;
  }

  void forces(std::size_t batch, std::span<Tet4Elements::Forces> f) const override {
    std::array<Mat3, elements_per_batch> P;
    for_laws(batch, [&](const ConstitutiveLaw& law, auto F, std::size_t at) {
      law.stress(F, std::span(&P[at], F.size()));
    });
    for (std::size_t e = 0; e < f.size(); ++e) elements_.forces(first(batch) + e, P[e], f[e]);
  }

  void stiffness(std::size_t batch, std::span<Tet4Elements::Stiffness> K) const override {
    std::array<Mat9, elements_per_batch> dPdF;
    for_laws(batch, [&](const ConstitutiveLaw& law, auto F, std::size_t at) {
      law.tangent(F, std::span(&dPdF[at], F.size()));
    });
    for (std::size_t e = 0; e < K.size(); ++e) elements_.stiffness(first(batch) + e, dPdF[e], K[e]);
  }

  void warped_stiffness(std::size_t batch, std::span<Tet4Elements::Stiffness> K) const override {
    LaneStrain strain = strain_[batch];
    if (objective()) {
      lane_rotations(strain);
    } else {
      for (std::size_t k = 0; k < 9; ++k) {
        for (double& entry : strain.R.at[k]) entry = k % 4 == 0 ? 1 : 0;
      }
    }
    lane_warped_stiffness(rest_[batch], strain.R, K);
  }

 private:
  /// Calls f(law, gradients, place of the first in the batch) for each run of elements of one material.
  template <class Call>
  void for_laws(std::size_t batch, const Call& f) const {
    const std::span<const Mat3> all = std::span(F_).subspan(first(batch), count(batch));
    for (std::size_t at = 0, end; at < all.size(); at = end) {
      const std::size_t kind = materials_.kind_of(first(batch) + at);
      for (end = at + 1; end < all.size() && materials_.kind_of(first(batch) + end) == kind;) ++end;
      f(*laws_[kind], all.subspan(at, end - at), at);
    }
  }

  std::vector<std::unique_ptr<ConstitutiveLaw>> laws_;  // of each material
  std::vector<Mat3> F_;
};

}  // namespace

std::unique_ptr<ElementBatches> make_law_batches(std::unique_ptr<ConstitutiveLaw> (*make)(const Material&),
                                                 const Materials& materials, const Tet4Elements& elements) {
  return std::make_unique<LawBatches>(make, materials, elements);
}

}  // namespace prosector
