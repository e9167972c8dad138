#include "server/physics/mechanics/soft/elements/law_batches.h"

#include <array>

#include "server/physics/mechanics/soft/base/find_row.h"
#include "server/physics/mechanics/soft/elements/corotational_kernel.h"
#include "server/physics/mechanics/soft/elements/isotropic_batches.h"
#include "server/physics/mechanics/soft/laws/fem_laws.h"

namespace prosector::soft {

LawBatches::LawBatches(std::unique_ptr<ConstitutiveLaw> (*make)(const Material&), const Materials& materials,
                       const Tet4Elements& elements)
    : ElementBatches(materials, elements) {
  for (const Material& material : materials.kinds) laws_.push_back(make(material));
}

Mat3 LawBatches::gradient(std::size_t batch, std::size_t lane) const {
  Mat3 F;
  for (std::size_t k = 0; k < 9; ++k) F.data()[k] = strain_[batch].F.at[k][lane];
  return F;
}

/// Calls f(law, gradients, pressures, index of the first in the batch) for each run of elements of one
/// material.
template <class Call>
void LawBatches::for_laws(std::size_t batch, const Call& f) const {
  std::array<Mat3, elements_per_batch> F;
  const std::size_t all = count(batch);
  for (std::size_t lane = 0; lane < all; ++lane) F[lane] = gradient(batch, lane);
  for (std::size_t at = 0, end; at < all; at = end) {
    const std::size_t kind = materials_.kind_of(first(batch) + at);
    for (end = at + 1; end < all && materials_.kind_of(first(batch) + end) == kind;) ++end;
    f(*laws_[kind], std::span<const Mat3>(&F[at], end - at),
      std::span<const double>(strain_[batch].pressure).subspan(at, end - at), at);
  }
}

double LawBatches::energy(std::size_t batch) const {
  std::array<double, elements_per_batch> W;
  for_laws(batch, [&](const ConstitutiveLaw& law, auto F, auto, std::size_t at) {
    law.energy_density(F, std::span(&W[at], F.size()));
  });
  double sum = 0;
  for (std::size_t e = 0; e < count(batch); ++e) sum += elements_.volume(first(batch) + e) * W[e];
  return sum;
}

void LawBatches::forces(std::size_t batch, std::span<Tet4Elements::Forces> f) const {
  std::array<Mat3, elements_per_batch> P;
  for_laws(batch, [&](const ConstitutiveLaw& law, auto F, auto pressure, std::size_t at) {
    law.stress(F, pressure, std::span(&P[at], F.size()));
  });
  for (std::size_t e = 0; e < f.size(); ++e) elements_.forces(first(batch) + e, P[e], f[e]);
}

void LawBatches::stiffness(std::size_t batch, std::span<Tet4Elements::Stiffness> K) const {
  std::array<Mat9, elements_per_batch> dPdF;
  for_laws(batch, [&](const ConstitutiveLaw& law, auto F, auto pressure, std::size_t at) {
    law.tangent(F, pressure, std::span(&dPdF[at], F.size()));
  });
  for (std::size_t e = 0; e < K.size(); ++e) elements_.stiffness(first(batch) + e, dPdF[e], K[e]);
}

void LawBatches::dilatations(std::size_t batch, std::span<double> theta) const {
  for_laws(batch, [&](const ConstitutiveLaw& law, auto F, auto, std::size_t at) {
    law.dilatation(F, theta.subspan(at, F.size()));
  });
}

void LawBatches::dilatation_forces(std::size_t batch, std::span<Tet4Elements::Forces> G) const {
  std::array<Mat3, elements_per_batch> gradient;
  for_laws(batch, [&](const ConstitutiveLaw& law, auto F, auto, std::size_t at) {
    law.dilatation_gradient(F, std::span(&gradient[at], F.size()));
  });
  for (std::size_t e = 0; e < G.size(); ++e) elements_.forces(first(batch) + e, gradient[e], G[e]);
}

void LawBatches::warped_dilatation_forces(std::size_t batch, std::span<Tet4Elements::Forces> G) const {
  lane_turned_gradients(rest_[batch], rotated(batch).R, G);
}

void LawBatches::warped_stiffness(std::size_t batch, std::span<Tet4Elements::Stiffness> K) const {
  const LaneStrain strain = rotated(batch);
  lane_warped_stiffness(rest_[batch], strain.R, K);
  for (std::size_t e = 0; e < K.size(); ++e) add_fiber(batch, strain.R, e, K[e]);
}

LaneStrain LawBatches::rotated(std::size_t batch) const {
  LaneStrain strain = strain_[batch];
  if (objective()) {
    lane_rotations(strain);
  } else {
    for (std::size_t k = 0; k < 9; ++k) {
      for (double& entry : strain.R.at[k]) entry = k % 4 == 0 ? 1 : 0;
    }
  }
  return strain;
}

/// Adds the stiffness of fibres along their rotated direction, unless they are slack.
void LawBatches::add_fiber(std::size_t batch, const LaneMatrix& R, std::size_t lane,
                           Tet4Elements::Stiffness& K) const {
  const std::size_t e = first(batch) + lane;
  const Material& material = materials_.of(e);
  if (material.fiber_stiffness == 0 || (gradient(batch, lane) * material.fiber).squaredNorm() < 1 - 1e-9)
    return;
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

std::unique_ptr<ElementBatches> make_law_batches(std::unique_ptr<ConstitutiveLaw> (*make)(const Material&),
                                                 const Materials& materials, const Tet4Elements& elements) {
  return std::make_unique<LawBatches>(make, materials, elements);
}

namespace {

template <IsotropicLaw law, auto make, bool fibers = false>
std::unique_ptr<ElementBatches> isotropic(const Materials& materials, const Tet4Elements& elements) {
  return make_isotropic_batches(law, fibers, make, materials, elements);
}

}  // namespace

const std::vector<BatchedLawRow>& batched_laws() {
  static const std::vector<BatchedLawRow> rows = {
      {"fem_corotational", make_corotational_batches},
      {"fem_linear", isotropic<IsotropicLaw::fem_linear, make_fem_linear>},
      {"fem_stvk", isotropic<IsotropicLaw::fem_stvk, make_fem_stvk>},
      {"fem_neo_hookean", isotropic<IsotropicLaw::fem_neo_hookean, make_fem_neo_hookean>},
      {"fem_neo_hookean_polynomial",
       isotropic<IsotropicLaw::fem_neo_hookean_polynomial, make_fem_neo_hookean_polynomial>},
      {"fem_fibers", isotropic<IsotropicLaw::fem_neo_hookean, make_fem_fibers, true>}};
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
