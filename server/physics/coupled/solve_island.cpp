#include "server/physics/coupled/solve_island.h"

#include <algorithm>
#include <cmath>

#include "server/physics/coupled/energy_guard.h"
#include "server/physics/coupled/island_system.h"
#include "server/physics/soft/effort.h"

namespace prosector {
namespace {

constexpr int rigid_newton_iterations = 12;
constexpr double enough_step =
    1e-5;  // m: a next Newton step below it, at the rate of the last two, is not taken
constexpr double converged_step = 1e-4;  // m
constexpr int halvings = 12, halvings_with_care = 40;
constexpr int newton_with_care = 4;   // times the scene's iterations
constexpr double violent_step = 0.1;  // diagonals of a body that its warm start may lead away
constexpr double armijo = 1e-4;
constexpr double rounding = 1e-12;  // of |E|: what a sum of this size cannot resolve

struct Limits {
  int newton = rigid_newton_iterations;
  bool alone = true;     // nothing touches or holds: the guard is on
  bool careful = false;  // exact tangents from the first on, long searches
  SolverSettings solver;
  std::string solver_name = "cg";
};

Limits limits_of(const Island& island) {
  Limits limits;
  if (island.soft.empty()) return limits;
  const SoftDesc& first = island.soft.front().body->desc();
  int steps_down = static_cast<int>(max_steps_down);
  for (const SoftMember& m : island.soft) steps_down = std::min(steps_down, m.state->steps_down);
  const Effort effort = effort_of(first, steps_down);
  limits.newton = effort.newton_iterations;
  limits.solver = {effort.solver_iterations, effort.solver_tolerance};
  limits.solver_name = first.solver;
  return limits;
}

/// Largest step length 1, ½, ¼ … that lowers the energy enough; 0 when none does. The system's last energy is
/// then the one at `next`.
double line_search(IslandSystem& system, const VecX& q, const VecX& step, double energy, double slope,
                   int halvings, VecX& next) {
  double length = 1;
  for (int i = 0; i < halvings; ++i, length /= 2) {
    next = q + length * step;
    const double there = system.energy(next);
    if (std::isfinite(there) && there <= energy + armijo * length * slope + rounding * std::abs(energy))
      return length;
  }
  return 0;
}

/// Inexact Newton (Dembo, Eisenstat and Steihaug 1982): what a tighter solve of the first of several
/// linearisations would gain, the next one changes again. Not where rigid bodies bear each other: errors
/// there are pushes, and light bodies under heavy ones drift.
double linear_tolerance(const Island& island, const Limits& limits) {
  const bool rigid_contact =
      std::any_of(island.contacts.begin(), island.contacts.end(),
                  [](const Contact& c) { return c.a.kind != ContactSide::Kind::soft; });
  return rigid_contact ? limits.solver.tolerance : std::sqrt(limits.solver.tolerance);
}

/// Whether the warm start of some soft body leads so far that it may be worse than none.
bool violent(const Island& island) {
  return std::any_of(island.soft.begin(), island.soft.end(), [](const SoftMember& m) {
    return m.state->warm_start.lpNorm<Eigen::Infinity>() > violent_step * m.body->diagonal();
  });
}

/// The least energy of some places to start from; the system's last energy is then the one there.
VecX best_start(IslandSystem& system, VecX guess, const VecX& start) {
  const double there = system.energy(guess), here = system.energy(start);
  if (!std::isfinite(there) || here < there) return start;
  system.energy(guess);
  return guess;
}

IslandReport minimise(IslandSystem& system, const Limits& limits, double tolerance, VecX& q) {
  const auto solver = make_solver(limits.solver_name);
  IslandReport report;
  VecX g(system.size()), step(system.size()), next(system.size());
  bool exact = limits.careful;
  system.linearise(q);
  system.energy(q);
  while (report.newton_iterations < limits.newton) {
    system.linearise(q);
    system.lag_friction(q);
    const double energy = system.energy_with_new_friction(q);
    system.gradient(q, g);
    const bool kept = system.assemble(q, exact);
    g = -g;
    step.setZero();
    SolveReport solved = solver->solve(system, g, {limits.solver.max_iterations, tolerance}, step);
    report.solver_iterations += solved.iterations;
    if (report.newton_iterations++ == 0 && step.lpNorm<Eigen::Infinity>() < converged_step) {
      solved = solver->solve(system, g, limits.solver, step);  // close to rest: this one is the last
      report.solver_iterations += solved.iterations;
    }
    report.residual = solved.residual;
    const double slope = -g.dot(step);
    if (!(slope < 0)) break;  // at rest, or not finite
    const double length =
        line_search(system, q, step, energy, slope, limits.careful ? halvings_with_care : halvings, next);
    if (length == 0 && !kept) {
      report.descended = false;
      break;
    }
    // A matrix kept misleads here; beside others, who touches whom may as well have changed.
    exact = exact || (kept && (limits.alone ? length < 1 : length == 0));
    if (length == 0) {
      system.energy(q);
      continue;
    }
    q.swap(next);
    const double before = report.last_step;
    report.last_step = length * step.lpNorm<Eigen::Infinity>();
    const double rate = before > 0 ? std::min(1.0, report.last_step / before) : 1;
    if (rate * report.last_step < enough_step) break;
  }
  report.converged = report.last_step < converged_step && std::isfinite(report.residual);
  return report;
}

int stages_of(const SoftMember& m) {
  return m.euler ? 1 : m.body->integrator().stages();
}

/// One attempt at the tick. `work`: J, by joints on each soft member.
IslandReport attempt(Island& island, const Limits& limits, double h, const Vec3& gravity,
                     std::vector<double>& work) {
  const double tolerance = linear_tolerance(island, limits);
  int stages = 1;
  for (const SoftMember& m : island.soft) stages = std::max(stages, stages_of(m));
  IslandReport report;
  IslandSystem system(island, h);  // displacements count from here, in every stage
  const VecX start = system.start();
  for (int stage = 0; stage < stages; ++stage) {
    for (SoftMember& m : island.soft) m.body->begin_stage(stage, h, gravity, *m.state, m.euler);
    VecX q = system.initial_guess();
    if (limits.careful || (limits.alone && violent(island))) q = best_start(system, std::move(q), start);
    IslandReport part = minimise(system, limits, tolerance, q);
    part.newton_iterations += report.newton_iterations;
    part.solver_iterations += report.solver_iterations;
    part.descended = part.descended && report.descended;
    report = part;
    report.finite = q.allFinite() && q.lpNorm<Eigen::Infinity>() < max_coordinate;
    if (!report.finite) return report;
    for (std::size_t m = 0; m < island.rigid.size(); ++m)
      island.rigid[m].twist = q.segment<6>(system.rigid_offset(m));
    for (Contact& c : island.contacts) c.force = system.normal_force(c, q);
    for (std::size_t m = 0; m < island.soft.size(); ++m) {
      SoftBody& body = *island.soft[m].body;
      body.finish_stage(stage, h, q.segment(system.soft_offset(m), 3 * body.nodes()), *island.soft[m].state);
    }
    if (stage + 1 == stages) system.joint_work(start, q, work);
  }
  return report;
}

/// Whether some body keeps a history of stress: what it gives back is no gain.
bool relaxing(const Island& island) {
  return std::any_of(island.soft.begin(), island.soft.end(),
                     [](const SoftMember& m) { return m.state->history.size() > 0; });
}

/// Methods of several steps or stages weigh a force otherwise than a rigid body does over the same tick: in
/// company of rigid bodies all are stepped by implicit Euler, so that what one loses the other gets.
void choose_integrators(Island& island) {
  for (SoftMember& m : island.soft) m.euler = !island.rigid.empty() || island.soft.size() > 1;
}

}  // namespace

IslandReport solve_island(Island& island, double h, const Vec3& gravity) {
  Limits limits = limits_of(island);
  choose_integrators(island);
  limits.alone = island.contacts.empty() && island.ties.empty() && !relaxing(island);
  EnergyGuard guard(island, gravity);
  std::vector<double> work(island.soft.size(), 0);
  if (!guard.sound()) {
    IslandReport lost;
    lost.finite = false;
    return lost;
  }
  IslandReport report = attempt(island, limits, h, gravity, work);
  if (limits.alone && (!report.finite || guard.gained(work))) {
    guard.rewind();
    limits.newton *= newton_with_care;
    limits.careful = true;
    for (SoftMember& m : island.soft) m.euler = m.guarded = true;
    std::fill(work.begin(), work.end(), 0.0);
    const IslandReport first = report;
    report = attempt(island, limits, h, gravity, work);
    report.newton_iterations += first.newton_iterations;
    report.solver_iterations += first.solver_iterations;
    if (!report.finite) {
      guard.rewind();
      return report;
    }
    if (guard.gained(work)) {
      guard.shorten(work);
      report.converged = false;
    }
  }
  if (!report.finite) {
    guard.rewind();
    return report;
  }
  if (limits.alone) guard.finish(work);
  for (SoftMember& m : island.soft)
    if (m.euler && m.body->integrator().remembers()) m.state->motion.has_history = false;
  return report;
}

}  // namespace prosector
