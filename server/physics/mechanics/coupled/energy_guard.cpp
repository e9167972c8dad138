#include "server/physics/mechanics/coupled/energy_guard.h"
#include "common/assert.h"
#include "server/physics/mechanics/soft/implicit_stepper.h"
#include "server/physics/mechanics/soft/incremental_potential.h"
#include "server/physics/mechanics/soft/mechanical_energy.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace prosector::coupled {
namespace {

// s: half-life of the slack, longer than the oscillation periods of soft organs.
constexpr double slack_halved = 2;
constexpr double least_kept = 0.9;     // fraction of the slack that is kept per tick, for any tick length
constexpr double most_slack = 8e-3;    // of the body's energy: largest slack
constexpr double allowance = 1e-5;     // of the energy at the start: relative tolerance
constexpr double least_strain = 1e-6;  // strain whose energy counts as rounding error
constexpr int share_halvings = 10;
constexpr double most_diagonals = 10;  // body diagonals per tick

Vec3 mean(const VecX& values, const VecX& mass) {
  PROSECTOR_ASSERT(values.size() == 3 * mass.size());
  return values.reshaped(3, mass.size()) * mass / mass.sum();
}

/// Sets values = mean + share·(values − mean), by node.
void gather_towards(const Vec3& mean, double share, Eigen::Ref<VecX> values) {
  auto columns = values.reshaped(3, values.size() / 3);
  columns = ((share * columns).colwise() + (1 - share) * mean).eval();
}

}  // namespace

void limit_speed(SoftMember& m, double h) {
  PROSECTOR_ASSERT(m.body != nullptr && m.state != nullptr && h > 0);
  const double most = most_diagonals * m.body->diagonal() / h;
  VecX& v = m.state->motion.v;
  if (!v.allFinite() || v.lpNorm<Eigen::Infinity>() * 2 < most) return;
  const Vec3 drift = mean(v, m.body->node_mass());
  for (Eigen::Index i = 0; i < m.body->nodes(); ++i) {
    const Vec3 own = v.segment<3>(3 * i) - drift;
    if (own.norm() <= most) continue;
    v.segment<3>(3 * i) = drift + most / own.norm() * own;
    m.limited = m.guarded = true;
  }
  if (!m.limited) return;
  m.state->motion.has_history = false;
  m.state->warm_start.setZero();
}

void EnergyGuard::begin(Island& island) {
  island_ = &island;
  before_.clear();
  after_.assign(island.soft.size(), 0);
  for (SoftMember& m : island.soft) {
    m.body->stepper().remember(*m.state);
    before_.push_back(stored(m));
  }
}

double EnergyGuard::stored(const SoftMember& m) const {
  return m.body->potential().elastic_energy(m.state->motion.x) +
         soft::kinetic_energy(m.body->node_mass(), m.state->motion.v);
}

double EnergyGuard::allowed(std::size_t m, double work) const {
  PROSECTOR_ASSERT(island_ != nullptr && m < before_.size());
  const SoftMember& s = island_->soft[m];
  const SoftDesc& desc = s.body->desc();
  const double stiffness = desc.material.youngs_modulus * s.body->total_mass() / desc.material.density;  // J
  return (1 + allowance) * (before_[m] + std::max(0.0, work)) + s.state->energy_slack +
         soft::fall_energy(s.body->node_mass(), s.body->stepper().remembered().x, s.state->motion.x,
                           s.weight) +
         least_strain * least_strain * stiffness;
}

bool EnergyGuard::sound() const {
  return std::all_of(before_.begin(), before_.end(), [](double energy) { return std::isfinite(energy); });
}

double EnergyGuard::before() const {
  return std::accumulate(before_.begin(), before_.end(), 0.0);
}

bool EnergyGuard::gained(const std::vector<double>& work) {
  PROSECTOR_ASSERT(island_ != nullptr && before_.size() == island_->soft.size() &&
                   work.size() == before_.size());
  bool any = false;
  for (std::size_t m = 0; m < island_->soft.size(); ++m) {
    const SoftMember& s = island_->soft[m];
    after_[m] = stored(s);
    any = any || !(after_[m] <= allowed(m, work[m]));
  }
  return any;
}

void EnergyGuard::rewind() {
  PROSECTOR_ASSERT(island_ != nullptr && before_.size() == island_->soft.size());
  for (SoftMember& s : island_->soft) s.body->stepper().recall(*s.state);
}

void EnergyGuard::shorten(const std::vector<double>& work) {
  PROSECTOR_ASSERT(island_ != nullptr && after_.size() == island_->soft.size() &&
                   work.size() == after_.size());
  for (std::size_t m = 0; m < island_->soft.size(); ++m) {
    if (after_[m] <= allowed(m, work[m])) continue;
    SoftMember& s = island_->soft[m];
    soft::Motion& motion = s.state->motion;
    const VecX& start = s.body->stepper().remembered().x;
    const VecX x = motion.x - start, v = motion.v;
    const Vec3 dx = mean(x, s.body->node_mass()), dv = mean(v, s.body->node_mass());
    double share = 0.5;
    for (int k = 0; k <= share_halvings; ++k, share = k < share_halvings ? share / 2 : 0) {
      motion.x = x;
      motion.v = v;
      gather_towards(dx, share, motion.x);
      gather_towards(dv, share, motion.v);
      motion.x += start;
      after_[m] = stored(s);
      if (after_[m] <= allowed(m, work[m])) break;
    }
    if (!(after_[m] <= allowed(m, work[m]))) {
      s.body->stepper().recall(*s.state);
      motion.v.setZero();
      after_[m] = stored(s);
    }
    motion.has_history = false;
    s.state->warm_start.setZero();
  }
}

void EnergyGuard::finish(const std::vector<double>& work, double h) {
  PROSECTOR_ASSERT(island_ != nullptr && after_.size() == island_->soft.size() &&
                   work.size() == after_.size() && h > 0);
  const double kept = std::max(least_kept, std::exp2(-h / slack_halved));
  for (std::size_t m = 0; m < island_->soft.size(); ++m) {
    soft::SoftBodyState& state = *island_->soft[m].state;
    // Stored energy may be negative by rounding, or by its law: then the slack is 0.
    const double most = most_slack * std::max(after_[m], 0.0);
    const double headroom = std::clamp(allowed(m, work[m]) - after_[m], 0.0, most);
    state.energy_slack = island_->soft[m].body->stepper().integrator().remembers() ? kept * headroom : 0;
  }
}

}  // namespace prosector::coupled
