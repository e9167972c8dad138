// Phases 2 to 6, in parts of a tick where something driven is so fast that it would pass what it should
// press.
//
// Contacts are linear in a tick: normals are those of its start. A plate that goes farther in it than a
// surface cell is beyond the tissue, or deep inside it, before a contact could say where out is. So the tick
// is taken in equal parts, each with contacts of its own, for everything: what hangs together stays in step.

#include <algorithm>
#include <cmath>

#include "server/physics/phase_clock.h"
#include "server/physics/rotation.h"

namespace prosector {
namespace {

constexpr double share_of_cell = 0.5;  // of a surface cell: what is driven in one part
constexpr int most_parts = 20;         // faster things pass, as they did

Pose between(const Pose& from, const Pose& to, double share) {
  return {from.p + share * (to.p - from.p), from.q.slerp(share, to.q)};
}

/// m: how far any point of a body with that half diagonal goes at most.
double way(const Pose& from, const Pose& to, double half_diagonal) {
  return (to.p - from.p).norm() + turn(from.q, to.q).norm() * half_diagonal;
}

/// One row a body: what all parts of the tick did.
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

}  // namespace

/// As many as keep what is driven from going farther in one than tissue in its way can follow; 1 where
/// nothing goes as far as a surface cell.
int Simulation::Impl::parts_of_tick() {
  double most = 1;
  bool fresh = false;
  for (std::size_t slot = 0; slot < model.rigid.size(); ++slot) {
    const auto& to = world.driven_to(slot);
    if (!to) continue;
    if (!fresh) refresh_colliders();
    fresh = true;
    const Collider& c = colliders[slot];
    const double far = way(c.pose, *to, (c.hi - c.lo).norm() / 2);
    for (std::size_t i = 0; i < soft.size(); ++i) {
      const double cell = model.soft[i]->desc().surface_cell;
      if (far <= cell || parts[soft_id(i)].out_of_touch() || !may_meet(i, c)) continue;
      const Vec3 reach = Vec3::Constant(far);
      if ((surfaces[i].lo().array() > (c.hi + reach).array()).any() ||
          (surfaces[i].hi().array() < (c.lo - reach).array()).any())
        continue;
      most = std::max(most, std::ceil(far / (share_of_cell * cell)));
    }
  }
  return static_cast<int>(std::min(most, static_cast<double>(most_parts)));
}

void Simulation::Impl::advance_in_parts(PhaseClock& clock) {
  earlier_exchanges.clear();
  step_h = model.h;
  const int count = parts_of_tick();
  if (count == 1) {
    advance(clock);
    return;
  }
  struct Driven {
    std::size_t slot;
    Pose from, to;
  };
  std::vector<Driven> driven;
  for (std::size_t slot = 0; slot < model.rigid.size(); ++slot)
    if (const auto& to = world.driven_to(slot)) driven.push_back({slot, world.motion(slot).pose, *to});
  std::vector<std::pair<Pose, Pose>> targets;
  for (const Hand& hand : hands) targets.emplace_back(hand.previous_target, hand.target);
  const auto restart = [&] {  // methods of several steps, and guesses, are of steps as long as the last
    for (SoftBodyState& state : soft) {
      state.motion.has_history = false;
      state.warm_start.setZero();
    }
  };
  restart();
  step_h = model.h / count;
  for (int k = 0; k < count; ++k) {
    const double share = 1.0 / count, begin = k * share, end = k + 1 == count ? 1 : (k + 1) * share;
    for (const Driven& d : driven)
      world.drive(d.slot, k + 1 == count ? d.to : between(d.from, d.to, end), step_h);
    for (std::size_t i = 0; i < hands.size(); ++i) {
      hands[i].previous_target = between(targets[i].first, targets[i].second, begin);
      hands[i].target = between(targets[i].first, targets[i].second, end);
    }
    if (k > 0) {
      earlier_exchanges = exchanges();
      for (Exchange& e : earlier_exchanges) e.points = 0;
    }
    advance(clock);
  }
  for (std::size_t i = 0; i < hands.size(); ++i)
    std::tie(hands[i].previous_target, hands[i].target) = targets[i];
  restart();
  join_rows(report.bodies);
}

/// step_h s on.
void Simulation::Impl::advance(PhaseClock& clock) {
  world.detect(step_h);
  clock.end(Phase::broad);
  grip_blades();
  detect_soft_contacts();
  clock.end(Phase::narrow);
  const std::vector<MixedIsland>& mixed = find_islands();
  clock.end(Phase::rigid);  // with the islands that Bullet solves at once
  gather(mixed);
  clock.end(Phase::islands);
  solve_islands();
  clock.end(Phase::coupled);
  world.integrate(step_h);
  bounce_rigid();
  clock.end(Phase::rigid);
}

}  // namespace prosector
