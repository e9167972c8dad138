#include "server/physics/coupled/solve_island.h"

#include <algorithm>
#include <cmath>

#include "server/physics/coupled/island_system.h"
#include "server/physics/soft/effort.h"

namespace prosector {
namespace {

constexpr int rigid_newton_iterations = 12;
constexpr double enough_step =
    1e-5;  // m: a next Newton step below it, at the rate of the last two, is not taken
constexpr double converged_step = 1e-4;  // m
constexpr int halvings = 12;
constexpr double armijo = 1e-4;
constexpr double rounding = 1e-12;  // of |E|: what a sum of this size cannot resolve

struct Limits {
  int newton = rigid_newton_iterations;
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
                   VecX& next) {
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

IslandReport minimise(IslandSystem& system, const Limits& limits, double tolerance, VecX& q) {
  const auto solver = make_solver(limits.solver_name);
  IslandReport report;
  VecX g(system.size()), step(system.size()), next(system.size());
  system.energy(q);
  while (report.newton_iterations < limits.newton) {
    system.lag_friction(q);
    const double energy = system.energy_with_new_friction(q);
    system.gradient(q, g);
    system.assemble(q);
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
    const double length = line_search(system, q, step, energy, slope, next);
    if (length == 0) break;
    q.swap(next);
    const double before = report.last_step;
    report.last_step = length * step.lpNorm<Eigen::Infinity>();
    const double rate = before > 0 ? std::min(1.0, report.last_step / before) : 1;
    if (rate * report.last_step < enough_step) break;
  }
  report.converged = report.last_step < converged_step && std::isfinite(report.residual);
  return report;
}

int stages_of(const Island& island) {
  int stages = 1;
  for (const SoftMember& m : island.soft) stages = std::max(stages, m.body->integrator().stages());
  return stages;
}

}  // namespace

IslandReport solve_island(Island& island, double h, const Vec3& gravity) {
  const Limits limits = limits_of(island);
  const double tolerance = linear_tolerance(island, limits);
  IslandReport report;
  IslandSystem system(island, h);  // displacements count from here, in every stage
  for (int stage = 0; stage < stages_of(island); ++stage) {
    for (SoftMember& m : island.soft)
      m.body->begin_stage(std::min(stage, m.body->integrator().stages() - 1), h, gravity, *m.state);
    VecX q = system.initial_guess();
    IslandReport part = minimise(system, limits, tolerance, q);
    part.newton_iterations += report.newton_iterations;
    part.solver_iterations += report.solver_iterations;
    report = part;
    report.finite = q.allFinite() && q.lpNorm<Eigen::Infinity>() < max_coordinate;
    if (!report.finite) return report;
    for (std::size_t m = 0; m < island.rigid.size(); ++m)
      island.rigid[m].twist = q.segment<6>(system.rigid_offset(m));
    for (Contact& c : island.contacts) c.force = system.normal_force(c, q);
    for (std::size_t m = 0; m < island.soft.size(); ++m) {
      SoftBody& body = *island.soft[m].body;
      body.finish_stage(std::min(stage, body.integrator().stages() - 1), h,
                        q.segment(system.soft_offset(m), 3 * body.nodes()), *island.soft[m].state);
    }
  }
  return report;
}

}  // namespace prosector
