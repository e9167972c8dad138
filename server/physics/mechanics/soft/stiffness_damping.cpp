#include "server/physics/mechanics/soft/stiffness_damping.h"

namespace prosector::soft {

StiffnessDamping::StiffnessDamping(const SoftSystem& system, StageElements& elements)
    : pattern_(system.pattern), elements_(elements), sum_(static_cast<std::size_t>(system.mass.size())) {
  fit(static_cast<std::size_t>(system.mass.size()));
}

void StiffnessDamping::fit(std::size_t nodes) {
  sum_ = NodeSum(nodes);
  drift_.setZero(3 * static_cast<Eigen::Index>(nodes));
  forces_.setZero(drift_.size());
  known_ = forces_known_ = false;
}

void StiffnessDamping::begin_stage(const VecX& x_v) {
  x_v_ = &x_v;
  known_ = forces_known_ = false;
}

void StiffnessDamping::update(const Eigen::Ref<const VecX>& x, bool forces) {
  const bool same = known_ && (x - *x_v_) == drift_;
  if (same && (forces_known_ || !forces)) return;
  drift_ = x - *x_v_;
  known_ = true;
  forces_known_ = forces || !elements_.turned();
  if (!elements_.turned()) {
    pattern_.multiply(elements_.damping_blocks(x), drift_.data(), forces_.data());
    energy_ =
        0.5 * sum_([&](Eigen::Index i) { return drift_.segment<3>(3 * i).dot(forces_.segment<3>(3 * i)); });
  } else if (forces) {
    energy_ = elements_.damping_forces(x, drift_, forces_);
  } else {
    energy_ = elements_.damping_energy(x, drift_);
  }
}

}  // namespace prosector::soft
