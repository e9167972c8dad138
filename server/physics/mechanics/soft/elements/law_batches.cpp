#include <array>

#include "server/physics/mechanics/soft/base/find_row.h"
#include "server/physics/mechanics/soft/elements/corotational_kernel.h"
#include "server/physics/mechanics/soft/elements/element_batches.h"

namespace prosector::soft {
namespace {

class LawBatches final : public ElementBatches {
 public:
  LawBatches(std::unique_ptr<ConstitutiveLaw> (*make)(const Material&), const Materials& materials,
             const Tet4Elements& elements)
      : ElementBatches(materials, elements), F_(elements.size()) {
    for (const Material& material : materials.kinds) laws_.push_back(make(material));
  }

  void follow(const SoftMaterial& material, const TetMesh& mesh, const MeshEdit& edit) override {
    ElementBatches::follow(material, mesh, edit);
    F_.resize(elements_.size());
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
      law.stress(F, pressures(batch, at, F.size()), std::span(&P[at], F.size()));
    });
    for (std::size_t e = 0; e < f.size(); ++e) elements_.forces(first(batch) + e, P[e], f[e]);
  }

  void stiffness(std::size_t batch, std::span<Tet4Elements::Stiffness> K) const override {
    std::array<Mat9, elements_per_batch> dPdF;
    for_laws(batch, [&](const ConstitutiveLaw& law, auto F, std::size_t at) {
      law.tangent(F, pressures(batch, at, F.size()), std::span(&dPdF[at], F.size()));
    });
    for (std::size_t e = 0; e < K.size(); ++e) elements_.stiffness(first(batch) + e, dPdF[e], K[e]);
  }

  void dilatations(std::size_t batch, std::span<double> theta) const override {
    for_laws(batch, [&](const ConstitutiveLaw& law, auto F, std::size_t at) {
      law.dilatation(F, theta.subspan(at, F.size()));
    });
  }

  void dilatation_forces(std::size_t batch, std::span<Tet4Elements::Forces> G) const override {
    std::array<Mat3, elements_per_batch> gradient;
    for_laws(batch, [&](const ConstitutiveLaw& law, auto F, std::size_t at) {
      law.dilatation_gradient(F, std::span(&gradient[at], F.size()));
    });
    for (std::size_t e = 0; e < G.size(); ++e) elements_.forces(first(batch) + e, gradient[e], G[e]);
  }

  void warped_dilatation_forces(std::size_t batch, std::span<Tet4Elements::Forces> G) const override {
    lane_turned_gradients(rest_[batch], warp(batch), G);
  }

  void warped_stiffness(std::size_t batch, std::span<Tet4Elements::Stiffness> K) const override {
    const LaneMatrix R = warp(batch);
    lane_warped_stiffness(rest_[batch], R, K);
    for (std::size_t e = 0; e < K.size(); ++e) add_fiber(first(batch) + e, R, e, K[e]);
  }

 private:
  /// Returns the rotations R of the batch; the identity for laws that are not objective.
  LaneMatrix warp(std::size_t batch) const {
    LaneStrain strain = strain_[batch];
    if (objective()) {
      lane_rotations(strain);
    } else {
      for (std::size_t k = 0; k < 9; ++k) {
        for (double& entry : strain.R.at[k]) entry = k % 4 == 0 ? 1 : 0;
      }
    }
    return strain.R;
  }

  /// Adds the stiffness of fibres along their rotated direction, unless they are slack.
  void add_fiber(std::size_t e, const LaneMatrix& R, std::size_t lane, Tet4Elements::Stiffness& K) const {
    const Material& material = materials_.of(e);
    if (material.fiber_stiffness == 0 || (F_[e] * material.fiber).squaredNorm() < 1 - 1e-9) return;
    Mat3 turn;
    for (std::size_t k = 0; k < 9; ++k) turn.data()[k] = R.at[k][lane];
    const Vec3 a = turn * material.fiber, b = elements_.gradients(e).transpose() * material.fiber;
    const std::array<double, 4> along = {-b.sum(), b[0], b[1], b[2]};
    const Mat3 aa = elements_.volume(e) * material.fiber_stiffness * a * a.transpose();
    for (int p = 0; p < 4; ++p)
      for (int q = p + 1; q < 4; ++q)
        K[static_cast<std::size_t>(Tet4Elements::pair_index(p, q))] +=
            along[static_cast<std::size_t>(p)] * along[static_cast<std::size_t>(q)] * aa;
  }

  std::span<const double> pressures(std::size_t batch, std::size_t at, std::size_t n) const {
    return std::span<const double>(strain_[batch].pressure).subspan(at, n);
  }
  /// Calls f(law, gradients, index of the first in the batch) for each run of elements of one material.
  template <class Call>
  void for_laws(std::size_t batch, const Call& f) const {
    const std::span<const Mat3> all = std::span(F_).subspan(first(batch), count(batch));
    for (std::size_t at = 0, end; at < all.size(); at = end) {
      const std::size_t kind = materials_.kind_of(first(batch) + at);
      for (end = at + 1; end < all.size() && materials_.kind_of(first(batch) + end) == kind;) ++end;
      f(*laws_[kind], all.subspan(at, end - at), at);
    }
  }

  std::vector<std::unique_ptr<ConstitutiveLaw>> laws_;  // by material
  std::vector<Mat3> F_;
};

}  // namespace

std::unique_ptr<ElementBatches> make_law_batches(std::unique_ptr<ConstitutiveLaw> (*make)(const Material&),
                                                 const Materials& materials, const Tet4Elements& elements) {
  return std::make_unique<LawBatches>(make, materials, elements);
}

const std::vector<BatchedLawRow>& batched_laws() {
  static const std::vector<BatchedLawRow> rows = {{"fem_corotational", make_corotational_batches}};
  return rows;
}

std::unique_ptr<ElementBatches> make_batches(const std::string& name, const Materials& materials,
                                             const Tet4Elements& elements) {
  const LawRow& law = find_row(laws(), "model", name);
  for (const BatchedLawRow& row : batched_laws())
    if (name == row.law) return row.make(materials, elements);
  return make_law_batches(law.make, materials, elements);
}

}  // namespace prosector::soft
