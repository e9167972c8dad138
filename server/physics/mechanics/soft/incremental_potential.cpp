#include "server/physics/mechanics/soft/incremental_potential.h"

#include <algorithm>
#include <vector>

#include "server/physics/base/parallel.h"
#include "server/physics/mechanics/soft/soft_body_setup.h"
#include "server/physics/mechanics/soft/solvers/linear_solver.h"

namespace prosector::soft {

IncrementalPotential::IncrementalPotential(const SoftMatter& matter)
    : matter_(matter),
      system_{matter.desc, *matter.model, matter.pattern, matter.symmetric, matter.inertia, matter.attached},
      elements_(system_, !matter.model->turns() || matter.desc.configuration.solver == "direct"),
      damping_(system_, elements_),
      node_sum_(matter.node_count()) {
  // The callers create the solvers; this only rejects unknown names.
  name_in_errors(matter.desc, [&] { return make_solver(matter.desc.configuration.solver); });
  reweigh();
}

void IncrementalPotential::reweigh() {
  hessian_.emplace(system_, elements_);
}

void IncrementalPotential::fit() {
  elements_.fit();
  damping_.fit(matter_.node_count());
  hessian_->fit();
  node_sum_ = NodeSum(matter_.node_count());
}

StageWeights IncrementalPotential::weights() const {
  return {stage_.alpha + matter_.desc.material.damping_mass / stage_.dxdv,
          matter_.desc.material.damping_stiffness / stage_.dxdv};
}

void IncrementalPotential::begin_stage(const VecX& start) {
  hessian_->begin_stage(start, weights());
  damping_.begin_stage(stage_.x_v);
}

void IncrementalPotential::linearise(const Eigen::Ref<const VecX>& x) {
  if (tangent_is_cheap() && !elements_.near_assembled(x)) elements_.linearise(x);
  if (system_.damped()) damping_.update(x, true);
}

double IncrementalPotential::energy(const Eigen::Ref<const VecX>& x) {
  const SoftMatter& m = matter_;
  if (system_.damped()) damping_.update(x, false);
  const double c = m.desc.material.damping_mass / stage_.dxdv,
               d = m.desc.material.damping_stiffness / stage_.dxdv;
  const double nodal = node_sum_([&](Eigen::Index i) {
    const auto at = [i](const auto& v) { return v.template segment<3>(3 * i); };
    double sum = m.inertia[i] * (stage_.alpha * (at(x) - at(stage_.y)).squaredNorm() +
                                 c * (at(x) - at(stage_.x_v)).squaredNorm());
    if (m.attached[i] > 0)
      sum +=
          m.attached[i] * ((at(x) - at(m.rest())).squaredNorm() + d * (at(x) - at(stage_.x_v)).squaredNorm());
    return 0.5 * sum;
  });
  const double damping = system_.damped() ? d * damping_.energy() : 0;
  return m.strength * (nodal + damping + m.model->energy(x.data()));
}

void IncrementalPotential::gradient(const Eigen::Ref<const VecX>& x, Eigen::Ref<VecX> g) {
  const SoftMatter& m = matter_;
  if (system_.damped()) damping_.update(x, true);
  const double c = m.desc.material.damping_mass / stage_.dxdv,
               d = m.desc.material.damping_stiffness / stage_.dxdv;
  parallel_short_chunks(
      m.node_count(), NodeSum::nodes_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
        for (std::size_t node = first; node < last; ++node) {
          const auto i = static_cast<Eigen::Index>(node);
          const auto at = [i](const auto& v) { return v.template segment<3>(3 * i); };
          Vec3 sum = m.inertia[i] * (stage_.alpha * (at(x) - at(stage_.y)) + c * (at(x) - at(stage_.x_v)));
          if (m.attached[i] > 0) sum += m.attached[i] * (at(x) - at(m.rest()) + d * (at(x) - at(stage_.x_v)));
          if (system_.damped()) sum += d * at(damping_.forces());
          g.segment<3>(3 * i) = sum;
        }
      });
  m.model->add_gradient(x.data(), g.data());
  if (m.strength != 1) g *= m.strength;
}

double IncrementalPotential::inertia_energy(const Eigen::Ref<const VecX>& x) const {
  double sum = 0;
  for (Eigen::Index i = 0; i < matter_.mass.size(); ++i)
    sum += matter_.mass[i] * (x.segment<3>(3 * i) - stage_.y.segment<3>(3 * i)).squaredNorm();
  return 0.5 * stage_.alpha * sum;
}

double IncrementalPotential::elastic_energy(const Eigen::Ref<const VecX>& x) {
  const SoftMatter& m = matter_;
  const double springs = node_sum_([&](Eigen::Index i) {
    return 0.5 * m.attached[i] * (x.segment<3>(3 * i) - m.rest().segment<3>(3 * i)).squaredNorm();
  });
  m.model->relax_fully();
  return m.strength * (springs + m.model->energy(x.data()));
}

void IncrementalPotential::assemble(const Eigen::Ref<const VecX>& x) {
  hessian_->assemble(x);
}

bool IncrementalPotential::assemble_roughly(const Eigen::Ref<const VecX>& x) {
  return hessian_->assemble_roughly(x);
}

void IncrementalPotential::scale(double factor, double* vector) const {
  if (factor != 1) Eigen::Map<VecX>(vector, matter_.rest().size()) *= factor;
}

void IncrementalPotential::multiply(const double* p, double* Hp) const {
  hessian_->multiply(p, Hp);
  scale(matter_.strength, Hp);
}

void IncrementalPotential::diagonal(std::span<Mat3> blocks) const {
  std::copy(hessian_->diagonal().begin(), hessian_->diagonal().end(), blocks.begin());
  if (matter_.strength == 1) return;
  for (Mat3& block : blocks) block *= matter_.strength;
}

void IncrementalPotential::factor_solve(const double* r, double* z) {
  hessian_->factor_solve(r, z);
  scale(1 / matter_.strength, z);
}

void IncrementalPotential::multigrid_solve(std::span<const Mat3> diagonal, std::span<const Mat3> inverse,
                                           const double* r, double* z) {
  const double strength = matter_.strength;
  if (strength == 1) return hessian_->multigrid_solve(diagonal, inverse, r, z);
  std::vector<Mat3> own(diagonal.begin(), diagonal.end()), own_inverse(inverse.begin(), inverse.end());
  for (Mat3& block : own) block /= strength;
  for (Mat3& block : own_inverse) block *= strength;
  hessian_->multigrid_solve(own, own_inverse, r, z);
  scale(1 / strength, z);
}

}  // namespace prosector::soft
