#include "server/physics/stations/tick_parts.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "common/assert.h"
#include "common/rotation.h"
#include "server/physics/stations/touching/rigid_soft_contacts.h"

namespace prosector {
namespace {

constexpr double share_of_cell = 0.5;  // of a surface cell: largest motion of a driven body in one part
constexpr int most_parts = 20;         // faster bodies may pass through tissue

Pose between(const Pose& from, const Pose& to, double share) {
  return {from.p + share * (to.p - from.p), from.q.slerp(share, to.q)};
}

/// Returns an upper bound of the motion of any point of a body with that half diagonal, m.
double way(const Pose& from, const Pose& to, double half_diagonal) {
  return (to.p - from.p).norm() + turn(from.q, to.q).norm() * half_diagonal;
}

/// Merges the rows of all parts of the tick into one row per body.
void join_rows(std::vector<BodyReport>& rows) {
  std::vector<BodyReport> out;
  for (BodyReport& row : rows) {
    const auto known =
        std::find_if(out.begin(), out.end(), [&](const auto& o) { return o.body == row.body; });
    if (known == out.end()) {
      out.push_back(std::move(row));
      continue;
    }
    known->newton_iterations += row.newton_iterations;
    known->solver_iterations += row.solver_iterations;
    known->residual = std::max(known->residual, row.residual);
    known->last_step = std::max(known->last_step, row.last_step);
    known->converged = known->converged && row.converged;
    known->reset = known->reset || row.reset;
    if (!row.note.empty()) known->note = row.note;
  }
  rows = std::move(out);
}

int count_parts(State& state, Colliders& colliders) {
  Bodies& bodies = state.bodies;
  double most = 1;
  bool fresh = false;
  for (std::size_t slot = 0; slot < bodies.model.rigid.size(); ++slot) {
    const auto& to = bodies.rigid.driven_to(slot);
    if (!to) continue;
    if (!fresh) refresh(colliders, bodies, state.hands, state.dissection.blades);
    fresh = true;
    PROSECTOR_ASSERT(slot < colliders.size());
    const contact::Collider& c = colliders[slot];
    const double far = way(c.pose, *to, (c.hi - c.lo).norm() / 2);
    for (const Tissue& tissue : bodies.soft) {
      const double cell = tissue.desc().geometry.surface_cell;
      if (far <= cell || bodies.parts[bodies.soft_id(tissue.index)].out_of_touch() || !may_meet(tissue, c))
        continue;
      const Vec3 reach = Vec3::Constant(far);
      const contact::SurfaceDetector& vertices = tissue.surface.vertices();
      if ((vertices.lo().array() > (c.hi + reach).array()).any() ||
          (vertices.hi().array() < (c.lo - reach).array()).any())
        continue;
      most = std::max(most, std::ceil(far / (share_of_cell * cell)));
    }
  }
  return static_cast<int>(std::min(most, static_cast<double>(most_parts)));
}

}  // namespace

TickParts::TickParts(State& state, Colliders& colliders)
    : state_(state), count_(count_parts(state, colliders)), h_(state.bodies.model.h) {
  if (count_ == 1) return;
  const Bodies& bodies = state.bodies;
  for (std::size_t slot = 0; slot < bodies.model.rigid.size(); ++slot)
    if (const auto& to = bodies.rigid.driven_to(slot))
      kinematic_.push_back({slot, bodies.rigid.motion(slot).pose, *to});
  for (const hands::Hand& hand : state.hands) targets_.emplace_back(hand.previous_target, hand.target);
  restart();
  h_ = bodies.model.h / count_;
}

/// Clears multi-step history and warm starts, which are valid for constant step length only.
void TickParts::restart() {
  for (Tissue& tissue : state_.bodies.soft) {
    tissue.state.motion.has_history = false;
    tissue.state.warm_start.setZero();
  }
}

void TickParts::aim(int k) {
  PROSECTOR_ASSERT(k >= 0 && k < count_);
  if (count_ == 1) return;
  const double share = 1.0 / count_, begin = k * share, end = k + 1 == count_ ? 1 : (k + 1) * share;
  for (const Kinematic& d : kinematic_)
    state_.bodies.rigid.drive(d.slot, k + 1 == count_ ? d.to : between(d.from, d.to, end), h_);
  for (std::size_t i = 0; i < state_.hands.size(); ++i) {
    state_.hands[i].previous_target = between(targets_[i].first, targets_[i].second, begin);
    state_.hands[i].target = between(targets_[i].first, targets_[i].second, end);
  }
}

void TickParts::finish(StepReport& report) {
  if (count_ == 1) return;
  for (std::size_t i = 0; i < state_.hands.size(); ++i)
    std::tie(state_.hands[i].previous_target, state_.hands[i].target) = targets_[i];
  restart();
  join_rows(report.bodies);
}

}  // namespace prosector
