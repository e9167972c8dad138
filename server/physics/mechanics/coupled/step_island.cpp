#include "server/physics/mechanics/coupled/step_island.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "common/assert.h"
#include "common/ids.h"
#include "common/math.h"
#include "server/physics/mechanics/coupled/energy_guard.h"
#include "server/physics/mechanics/coupled/impulse_coupling.h"
#include "server/physics/mechanics/coupled/island_solver.h"
#include "server/physics/mechanics/coupled/recovery.h"
#include "server/physics/mechanics/soft/incremental_potential.h"
#include "server/physics/mechanics/soft/integrators/substepper.h"
#include "server/physics/mechanics/soft/mechanical_energy.h"

namespace prosector::coupled {
namespace {

constexpr double least_power = 6e-5;  // W, per body of 1 kg or more: smaller power is ignored
constexpr int tries = 2;              // attempts by substeps before a body that became too stiff is minimised
constexpr int refinements = 2;        // largest number of refinements for a small energy gain
constexpr double negligible_speed = 0.02;  // m/s: energy of a body at this speed is small
constexpr double most_unexplained = 0.2;   // of the body's energy: unexplained gain after the last refinement

bool good(const soft::SoftBodyState& state) {
  return state.motion.x.allFinite() && state.motion.v.allFinite() &&
         state.motion.x.lpNorm<Eigen::Infinity>() < max_coordinate;
}

/// Buffers of a tick, by soft member unless noted.
struct TickBuffers {
  std::vector<soft::SoftBodyState> start;
  std::vector<double> energy;     // J: at the tick's start
  std::vector<SubstepWork> work;  // of impulses
  std::vector<char> substepped, minimised_always;
  std::vector<std::size_t> contacts, ties;         // indices of joints of substepped bodies
  Island rest;                                     // the island without substepped bodies and their joints
  std::vector<std::size_t> contact_of, member_of;  // indices in the island, by contact and member of `rest`
  ImpulseCoupling coupling;
};

/// Solvers by the first soft member's index, so that each island of a scene reuses its buffers.
using Solvers = std::map<std::size_t, IslandSolver>;
IslandSolver& solver_of(const Island& island, Solvers& solvers) {
  constexpr std::size_t rigid = std::numeric_limits<std::size_t>::max();
  return solvers[island.soft.empty() ? rigid : island.soft.front().index];
}

/// Attempts of a tick, each with its own choice of substepped bodies.
class Tick {
 public:
  Tick(Island& island, double h, TickBuffers& buffers, Solvers& solvers)
      : island_(island),
        h_(h),
        start_(buffers.start),
        energy_(buffers.energy),
        work_(buffers.work),
        substepped_(buffers.substepped),
        minimised_always_(buffers.minimised_always),
        buffers_(buffers),
        solvers_(solvers) {
    start_.resize(island.soft.size());
    energy_.clear();
    for (std::size_t m = 0; m < island.soft.size(); ++m) {
      start_[m] = *island.soft[m].state;
      energy_.push_back(island.soft[m].body->substepper() ? energy(island.soft[m]) : 0);
    }
    work_.assign(island.soft.size(), {});
    minimised_always_.assign(island.soft.size(), 0);
  }

  IslandReport run() {
    for (int attempt = 0;; ++attempt) {
      decide();
      const IslandReport report = minimise();
      if (report.finite) substep();
      if (!report.finite || check(attempt)) return report;
    }
  }

 private:
  static double energy(const SoftMember& m) {
    return m.body->potential().elastic_energy(m.state->motion.x) +
           soft::kinetic_energy(m.body->node_mass(), m.state->motion.v);
  }

  double fallen(std::size_t m) const {
    const SoftMember& member = island_.soft[m];
    return std::max(0.0, soft::fall_energy(member.body->node_mass(), start_[m].motion.x,
                                           member.state->motion.x, member.weight));
  }

  /// Returns whether a substepped body's energy is explained by its start, gravity and impulses. Includes the
  /// strain that the method allows for impulses.
  bool tame(std::size_t m) const {
    PROSECTOR_ASSERT(m < energy_.size() && island_.soft[m].body->substepper() != nullptr);
    const SoftMember& member = island_.soft[m];
    const soft::Substepper& own = *member.body->substepper();
    const double explained =
        own.most_gain(h_) * (energy_[m] + fallen(m)) + own.most_pushed(h_) * std::max(0.0, work_[m].done);
    return energy(member) <= explained + least_power * std::min(1.0, member.body->total_mass()) * h_;
  }

  /// Returns whether the body has no unexplained energy. Energy that impulses removed is taken into account.
  /// Energy that contacts gave to both of their sides, beyond opening overlaps, explains nothing.
  bool passive(std::size_t m) const { return unexplained(m) <= 0; }

  /// Returns whether the unexplained energy is large enough to prefer implicit Euler. Returns false while
  /// more substeps could still help, and for small energies.
  bool wild(std::size_t m, int attempt) const {
    return attempt >= refinements && unexplained(m) > most_unexplained * (energy_[m] + fallen(m));
  }

  /// Returns the body's unexplained energy, J.
  double unexplained(std::size_t m) const {
    const SoftMember& member = island_.soft[m];
    const auto moving = [&](double speed) { return member.body->total_mass() * speed * speed / 2; };
    const double made = std::max(0.0, work_[m].made - moving(thin_opening_speed));
    return energy(member) - (member.body->substepper()->most_gain(h_) * (energy_[m] + fallen(m)) +
                             work_[m].done - made + moving(negligible_speed));
  }

  void decide() {
    substeps_ = 0;
    substepped_.assign(island_.soft.size(), 0);
    for (std::size_t m = 0; m < island_.soft.size(); ++m) {
      SoftMember& member = island_.soft[m];
      const soft::Substepper* own = member.body->substepper();
      if (!own) continue;
      member.substeps = 0;
      const double needed = own->needed(h_, *member.state);
      substepped_[m] = needed <= own->allowed() && !minimised_always_[m];
      if (substepped_[m])
        substeps_ = std::max(substeps_, static_cast<int>(needed));
      else
        refuse(member, needed);
    }
    join_minimised();
    for (std::size_t m = 0; m < island_.soft.size(); ++m) {
      if (!substepped_[m]) continue;
      island_.soft[m].substeps = substeps_;
      say(island_.soft[m],
          "stepped in {} substeps of {:.3g} ms per tick, coupled to other bodies by impulses{}", substeps_,
          1e3 * h_ / substeps_, island_.soft[m].body->substepper()->remark());
    }
  }

  /// Formats into the note's existing memory, since notes are written every tick.
  template <class... Values>
  static void say(SoftMember& member, fmt::format_string<const Values&...> text, const Values&... values) {
    member.note.clear();
    fmt::format_to(std::back_inserter(member.note), text, values...);
  }

  void refuse(SoftMember& member, double needed) const {
    const SoftDesc& desc = member.body->desc();
    const soft::Substepper& own = *member.body->substepper();
    const std::string& method =
        desc.configuration.is_position_based() ? desc.configuration.model : desc.configuration.integrator;
    member.degraded = true;
    member.refused = own.has_limit();
    if (needed <= own.allowed())
      say(member, "method {} was unstable in this tick: stepped with implicit_euler", method);
    else if (!own.has_limit())
      say(member, "method {} gains energy even with {} substeps per tick: stepped with implicit_euler{}",
          method, own.allowed(), own.remark());
    else if (std::isfinite(needed))
      say(member,
          "method {} needs {:.0f} substeps of {:.3g} ms per tick; at most {} are allowed (max_substeps): "
          "stepped with implicit_euler",
          method, needed, 1e3 * h_ / needed, desc.configuration.max_substeps);
    else
      say(member, "method {} is unstable at any step size without more damping: stepped with implicit_euler",
          method);
  }

  /// Moves bodies in contact with a minimised body to the minimised ones, repeatedly. A minimised body takes
  /// a tick in one step: impulses within the tick would hit single nodes, whose neighbours react only in the
  /// next tick.
  void join_minimised() {
    for (bool again = true; again;) {
      again = false;
      for (const contact::Contact& c : island_.contacts) {
        if (c.a.kind != contact::ContactSide::Kind::soft || c.b.kind != contact::ContactSide::Kind::soft)
          continue;
        const std::size_t a = member_of(c.a), b = member_of(c.b);
        if (substepped_[a] == substepped_[b]) continue;
        const std::size_t joins = substepped_[a] ? a : b;
        substepped_[joins] = 0;
        say(island_.soft[joins],
            "stepped with implicit_euler instead of substeps, because it touches a body stepped implicitly");
        island_.soft[joins].degraded = true;
        again = true;
      }
    }
    if (std::none_of(substepped_.begin(), substepped_.end(), [](char s) { return s != 0; })) substeps_ = 0;
  }

  std::size_t member_of(const contact::ContactSide& side) const {
    PROSECTOR_ASSERT(side.kind == contact::ContactSide::Kind::soft);
    std::size_t m = 0;
    while (island_.soft[m].index != side.body) ++m;
    return m;
  }

  bool of_substepped(const contact::ContactSide& side) const {
    if (side.kind != contact::ContactSide::Kind::soft) return false;
    for (std::size_t m = 0; m < island_.soft.size(); ++m)
      if (island_.soft[m].index == side.body) return substepped_[m] != 0;
    return false;
  }

  /// Minimises everything except the substepped bodies and their joints.
  IslandReport minimise() {
    Island& rest = buffers_.rest;
    auto &contact_of = buffers_.contact_of, &member_of = buffers_.member_of;
    for (auto* indices : {&buffers_.contacts, &buffers_.ties, &contact_of, &member_of}) indices->clear();
    rest.soft.clear();
    rest.contacts.clear();
    rest.ties.clear();
    rest.rigid = island_.rigid;
    for (std::size_t m = 0; m < island_.soft.size(); ++m)
      if (!substepped_[m]) {
        const SoftMember& member = island_.soft[m];
        rest.soft.push_back({member.index, member.body, member.state});
        rest.soft.back().weight = member.weight;
        rest.soft.back().guarded = member.guarded;
        member_of.push_back(m);
      }
    for (std::size_t c = 0; c < island_.contacts.size(); ++c) {
      const contact::Contact& contact = island_.contacts[c];
      if (of_substepped(contact.a) || of_substepped(contact.b)) {
        buffers_.contacts.push_back(c);
      } else {
        rest.contacts.push_back(contact);
        contact_of.push_back(c);
      }
    }
    for (std::size_t t = 0; t < island_.ties.size(); ++t) {
      const contact::Tie& tie = island_.ties[t];
      if (of_substepped(tie.a) || of_substepped(tie.b))
        buffers_.ties.push_back(t);
      else
        rest.ties.push_back(tie);
    }
    IslandReport report;
    report.converged = true;
    if (rest.soft.empty() && rest.rigid.empty()) return report;
    report = solver_of(rest, solvers_).solve(rest, h_);
    PROSECTOR_ASSERT(member_of.size() == rest.soft.size() && contact_of.size() == rest.contacts.size());
    island_.rigid = rest.rigid;
    for (std::size_t m = 0; m < member_of.size(); ++m)
      island_.soft[member_of[m]].guarded = rest.soft[m].guarded;
    for (std::size_t c = 0; c < contact_of.size(); ++c) island_.contacts[contact_of[c]] = rest.contacts[c];
    return report;
  }

  void substep() {
    if (substeps_ > 0)
      buffers_.coupling.run(island_, {start_, substepped_, buffers_.contacts, buffers_.ties, substeps_, h_},
                            work_);
  }

  /// Returns whether the tick is accepted. Otherwise restores all states, except the learnt frequencies.
  bool check(int attempt) {
    bool again = false;
    for (std::size_t m = 0; m < island_.soft.size(); ++m) {
      SoftMember& member = island_.soft[m];
      soft::Substepper* own = member.body->substepper();
      if (!own) continue;
      const bool held = own->finish(substepped_[m] ? h_ / substeps_ : 0, *member.state);
      if (!substepped_[m]) continue;
      const bool sound = good(*member.state) && tame(m);
      if (held && sound && wild(m, attempt)) {
        minimised_always_[m] = again = true;
        continue;
      }
      if (held && sound) {
        if (attempt < refinements && !passive(m)) again |= own->refine(h_, substeps_, *member.state);
        continue;
      }
      again = true;
      const bool more = !sound && (work_[m].done == 0 || attempt < refinements) &&
                        own->refine(h_, substeps_, *member.state);
      minimised_always_[m] = !more && (attempt + 1 >= tries || !sound);
    }
    if (!again) return true;
    for (std::size_t m = 0; m < island_.soft.size(); ++m) {
      soft::SoftBodyState& state = *island_.soft[m].state;
      const double omega =
          std::isfinite(state.omega) ? std::max(state.omega, start_[m].omega) : start_[m].omega;
      state = start_[m];
      state.omega = omega;
    }
    return false;
  }

  Island& island_;
  double h_;
  std::vector<soft::SoftBodyState>& start_;
  std::vector<double>& energy_;
  std::vector<SubstepWork>& work_;
  std::vector<char>&substepped_, &minimised_always_;
  TickBuffers& buffers_;
  Solvers& solvers_;
  int substeps_ = 0;
};

}  // namespace

struct IslandStepper::Buffers {
  TickBuffers tick;
  Solvers solvers;
  // By soft member: the body itself, if another law's body replaces it in the tick.
  std::vector<soft::SoftBody*> own;
};

IslandStepper::IslandStepper() : buffers_(std::make_unique<Buffers>()) {}
IslandStepper::~IslandStepper() = default;
IslandStepper::IslandStepper(IslandStepper&&) noexcept = default;

IslandReport IslandStepper::step(Island& island, double h, const Vec3& gravity) {
  PROSECTOR_ASSERT(h > 0);
  std::vector<soft::SoftBody*>& own = buffers_->own;
  own.clear();
  for (SoftMember& m : island.soft) {
    own.push_back(m.body);
    choose_law(m, h);
    m.body = &m.body->in_force(*m.state);
    if (island.contacts.empty() && island.ties.empty()) limit_speed(m, h);
  }
  const bool sane = gravity.allFinite();
  weigh(island, sane ? gravity : Vec3(Vec3::Zero()));
  const bool substeps = std::any_of(island.soft.begin(), island.soft.end(),
                                    [](const SoftMember& m) { return m.body->substepper() != nullptr; });
  const IslandReport report = substeps ? Tick(island, h, buffers_->tick, buffers_->solvers).run()
                                       : solver_of(island, buffers_->solvers).solve(island, h);
  for (std::size_t i = 0; i < own.size(); ++i) {
    SoftMember& m = island.soft[i];
    m.body = own[i];
    if (m.limited)
      m.note =
          "nodes moved by more than ten times the body's diagonal in one tick: their displacement was "
          "limited";
    if (!sane) m.note = "the scene's gravity is not a finite number: the tick was computed without gravity";
    if (m.guarded && m.note.empty())
      m.note = "the body gained energy: the tick was repeated with implicit_euler and tighter tolerances";
  }
  return report;
}

}  // namespace prosector::coupled
