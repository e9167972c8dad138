#include "server/physics/mechanics/coupled/island_solver.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/assert.h"
#include "common/commands.h"
#include "common/ids.h"
#include "server/physics/base/parallel.h"
#include "server/physics/mechanics/soft/base/effort.h"
#include "server/physics/mechanics/soft/implicit_stepper.h"
#include "server/physics/mechanics/soft/mechanical_energy.h"

namespace prosector::coupled {
namespace {

constexpr int rigid_newton_iterations = 12;
// m: iteration stops if the next Newton step, predicted from the ratio of the last two, is shorter.
constexpr double enough_step = 1e-5;
constexpr double enough_share = 0.05;   // of the friction slip threshold: step tolerance where friction acts
constexpr double enough_size = 6e-5;    // step tolerance of a small body, as a fraction of its diagonal
constexpr double enough_square = 4e-3;  // 1/m: times the squared diagonal; the larger tolerance counts
// Times the step tolerance: a tick with a shorter last step has converged.
constexpr double converged_steps = 10;
constexpr double most_unsolved = 0.3;  // relative residual above which a linear solve counts as inaccurate
constexpr double still_share = 0.01;   // factor on the convergence limit after an inaccurate solve
// m: with several soft bodies, iteration continues after longer steps, as stopping may gain energy.
constexpr double rough_step = 3e-3;
constexpr int halvings = 12, halvings_with_care = 40;
constexpr int newton_until_settled = 4;  // limit while contacts still change, times the scene's iterations
constexpr int newton_with_care = 4;      // times the scene's iterations
constexpr int solver_with_care = 4;      // times the scene's iterations, for islands with contacts or ties
// Allowed energy gain of an island with contacts or ties, per tick, as a fraction of its energy.
constexpr double most_gain = 0.12;
constexpr double small_speed = 0.02;  // m/s: allows the tissue's kinetic energy at this speed in addition
constexpr double violent_step = 0.1;  // body diagonals: longer warm starts may be worse than none
constexpr double armijo = 1e-4;
constexpr const char* rigid_solver = "cg";  // for islands without a soft body
constexpr double rounding = 1e-12;          // of |E|: rounding error of the energy sum

/// Returns whether rigid bodies that rest on tissue, directly or through others, touch other rigid bodies.
/// Counts bodies without a pull only: a pulled hand keeps its pose, and tissue is not affected by the bodies
/// that the hand pushes.
bool borne_by_tissue(const Island& island, std::vector<BorneBody>& bodies) {
  bodies.clear();
  for (const RigidMember& m : island.rigid)
    if (!m.pull) bodies.push_back({m.slot, false});
  std::sort(bodies.begin(), bodies.end(), [](const auto& a, const auto& b) { return a.slot < b.slot; });
  const auto find = [&](const contact::ContactSide& side) {
    if (side.kind != contact::ContactSide::Kind::rigid) return bodies.end();
    const auto at =
        std::lower_bound(bodies.begin(), bodies.end(), side.body,
                         [](const BorneBody& body, std::size_t slot) { return body.slot < slot; });
    return at != bodies.end() && at->slot == side.body ? at : bodies.end();
  };
  bool more = !bodies.empty();
  const auto spread = [&](const contact::ContactSide& from, const contact::ContactSide& to) {
    const auto giver = find(from), taker = find(to);
    if (taker == bodies.end() || taker->on_tissue) return;
    if (from.kind == contact::ContactSide::Kind::soft || (giver != bodies.end() && giver->on_tissue))
      taker->on_tissue = more = true;
  };
  const auto spread_both = [&](const auto& joint) {
    spread(joint.a, joint.b);
    spread(joint.b, joint.a);
  };
  while (std::exchange(more, false)) {
    std::for_each(island.contacts.begin(), island.contacts.end(), spread_both);
    std::for_each(island.ties.begin(), island.ties.end(), spread_both);
  }
  const auto borne = [&](const contact::ContactSide& side) {
    const auto known = find(side);
    return known != bodies.end() && known->on_tissue;
  };
  return std::any_of(island.contacts.begin(), island.contacts.end(), [&](const contact::Contact& c) {
    return c.a.kind != contact::ContactSide::Kind::soft && (borne(c.a) || borne(c.b));
  });
}

/// Returns the linear solver's tolerance for inexact Newton (Dembo, Eisenstat and Steihaug 1982). A tighter
/// solve of an early linearisation gains little, since the next one changes the result. The tolerance stays
/// tight where rigid bodies on tissue touch: errors there act as pushes, and light bodies under heavy ones
/// drift.
double linear_tolerance(const Island& island, double tolerance, std::vector<BorneBody>& bodies) {
  const bool borne = island.soft.empty() ? !island.contacts.empty() : borne_by_tissue(island, bodies);
  return borne ? tolerance : std::sqrt(tolerance);
}

/// Returns the step tolerance, m, by body size. Bodies of 5 cm and more, and rigid bodies, have enough_step.
double enough_for_size(const Island& island) {
  double enough = enough_step;
  for (const SoftMember& m : island.soft) {
    const double diagonal = m.body->diagonal();
    enough = std::min(enough, std::max(enough_size * diagonal, enough_square * diagonal * diagonal));
  }
  return enough;
}

/// Returns the step tolerance, m. Sticking contacts move by less than their slip threshold: longer steps
/// would leave them trembling and creeping.
double enough(const Island& island) {
  const bool rough = std::any_of(island.contacts.begin(), island.contacts.end(),
                                 [](const contact::Contact& c) { return c.friction > 0; });
  const double by_size = enough_for_size(island);
  return rough ? std::min(by_size, enough_share * slip_threshold) : by_size;
}

/// Returns whether the warm start of some soft body is so long that it may be worse than none.
bool violent(const Island& island) {
  return std::any_of(island.soft.begin(), island.soft.end(), [](const SoftMember& m) {
    return m.state->warm_start.lpNorm<Eigen::Infinity>() > violent_step * m.body->diagonal();
  });
}

int stages_of(const SoftMember& m) {
  return m.euler ? 1 : m.body->stepper().integrator().stages();
}

/// Returns whether some body has a stress history. The energy that it returns is no gain.
bool relaxing(const Island& island) {
  return std::any_of(island.soft.begin(), island.soft.end(),
                     [](const SoftMember& m) { return m.state->history.size() > 0; });
}

/// Returns whether the island has soft bodies and all consist of tetrahedra. Sheets and ropes are so light
/// that contacts can change their energy by any factor.
bool solid(const Island& island) {
  return !island.soft.empty() && std::all_of(island.soft.begin(), island.soft.end(), [](const SoftMember& m) {
    return !m.body->linear_tets().tets.empty();
  });
}

/// Sets implicit Euler for soft bodies that are coupled with rigid or other soft ones, so that momentum is
/// conserved. Multi-step and multi-stage methods weight forces differently than a rigid body does over the
/// same tick.
void choose_integrators(Island& island) {
  for (SoftMember& m : island.soft) m.euler = !island.rigid.empty() || island.soft.size() > 1;
}

/// Returns whether nothing holds the island in the room.
bool floats(const Island& island) {
  const auto to_room = [](const auto& joint) {
    return joint.a.kind == contact::ContactSide::Kind::fixed ||
           joint.b.kind == contact::ContactSide::Kind::fixed;
  };
  return std::none_of(island.contacts.begin(), island.contacts.end(), to_room) &&
         std::none_of(island.ties.begin(), island.ties.end(), to_room) &&
         std::none_of(island.soft.begin(), island.soft.end(),
                      [](const SoftMember& m) { return m.body->attached(); }) &&
         std::none_of(island.rigid.begin(), island.rigid.end(),
                      [](const RigidMember& m) { return m.pull.has_value(); });
}

/// Returns whether no body of the island moves freely.
bool all_held(const Island& island) {
  return !floats(island) && std::all_of(island.rigid.begin(), island.rigid.end(),
                                        [](const RigidMember& m) { return m.pull.has_value(); });
}

}  // namespace

struct IslandSolver::Limits {
  int newton = rigid_newton_iterations;
  bool alone = true;  // no contacts or ties: the energy of each body is checked
  // The island's energy is checked: contacts or ties, no stress history, nothing driven.
  bool in_company = false;
  bool several = false;  // several soft bodies
  bool held = false;     // nothing moves freely: momentum need not be conserved
  bool careful = false;  // exact tangents from the first iteration, more halvings in the line search
  double enough = enough_step, converged = converged_steps * enough_step;  // m, of Newton steps
  soft::SolverSettings settings;
  soft::LinearSolver* solver = nullptr;
};

IslandSolver::Limits IslandSolver::limits_of(const Island& island) {
  Limits limits;
  const bool soft = !island.soft.empty();
  const std::string name = soft ? island.soft.front().body->desc().configuration.solver : rigid_solver;
  std::unique_ptr<soft::LinearSolver>& solver = solvers_[name];
  if (!solver) solver = soft::make_solver(name);
  limits.solver = solver.get();
  limits.alone = island.contacts.empty() && island.ties.empty() && !relaxing(island);
  limits.in_company = !limits.alone && solid(island) && !relaxing(island) && !island.driven;
  limits.several = island.soft.size() > 1;
  limits.held = all_held(island);
  limits.enough = enough(island);
  limits.converged = converged_steps * enough_for_size(island);
  if (!soft) return limits;
  int steps_down = static_cast<int>(max_steps_down);
  for (const SoftMember& m : island.soft) steps_down = std::min(steps_down, m.state->steps_down);
  const soft::Effort effort = soft::effort_of(island.soft.front().body->desc().configuration, steps_down);
  limits.newton = effort.newton_iterations;
  limits.settings = {effort.solver_iterations, effort.solver_tolerance};
  return limits;
}

/// Returns the largest step length 1, ½, ¼ … that decreases the energy enough; 0 if none does. On return,
/// next_ and the system's last energy belong to that length.
double IslandSolver::line_search(double energy, double slope, int halvings) {
  PROSECTOR_ASSERT(slope < 0 && halvings > 0 && q_.size() == step_.size());
  double length = 1;
  for (int i = 0; i < halvings; ++i, length /= 2) {
    next_ = q_ + length * step_;
    const double there = system_.energy(next_);
    if (std::isfinite(there) && there <= energy + armijo * length * slope + rounding * std::abs(energy))
      return length;
  }
  return 0;
}

/// Starts at q_, or at the tick's start if the energy is lower there.
void IslandSolver::start_where_energy_is_least() {
  const double there = system_.energy(q_), here = system_.energy(start_);
  if (!std::isfinite(there) || here < there)
    q_ = start_;
  else
    system_.energy(q_);
}

/// Minimises the energy starting from q_; stores the result in q_.
IslandReport IslandSolver::minimise(const Limits& limits, double tolerance) {
  IslandReport report;
  for (VecX* v : {&solved_, &step_}) v->resize(system_.size());
  bool exact = limits.careful;
  system_.linearise(q_);
  system_.energy(q_);
  bool unsettled = false;
  while (report.newton_iterations < limits.newton ||
         (unsettled && report.newton_iterations < newton_until_settled * limits.newton)) {
    system_.linearise(q_);
    system_.joints().lag_friction(q_);
    const double energy = system_.energy_with_new_friction(q_);
    system_.gradient(q_, g_);
    const bool kept = system_.assemble(q_, exact);
    g_ = -g_;
    right_ = g_;
    system_.condense(right_);
    solved_.setZero();
    soft::SolveReport solved =
        limits.solver->solve(system_, right_, {limits.settings.max_iterations, tolerance}, solved_);
    report.solver_iterations += solved.iterations;
    system_.expand(g_, solved_, step_);
    if (report.newton_iterations++ == 0 && step_.lpNorm<Eigen::Infinity>() < limits.converged) {
      // Close to rest: this iteration is the last.
      if (!limits.held) system_.joints().take_balanced();
      solved = limits.solver->solve(system_, right_, limits.settings, solved_);
      report.solver_iterations += solved.iterations;
      system_.expand(g_, solved_, step_);
    }
    report.residual = solved.residual;
    const double slope = -g_.dot(step_);
    if (!(slope < 0)) {  // at rest, or not finite
      if (report.newton_iterations == 1) system_.joints().take(1, step_.setZero());
      break;
    }
    const double length = line_search(energy, slope, limits.careful ? halvings_with_care : halvings);
    if (length == 0 && !kept) {
      report.descended = false;
      break;
    }
    // A kept matrix is inaccurate here. With other bodies, a change of contacts may be the cause as well.
    exact = exact || (kept && (limits.alone ? length < 1 : length == 0));
    if (length == 0) {
      system_.energy(q_);
      unsettled = true;
      continue;
    }
    q_.swap(next_);
    system_.joints().take(length, step_);
    const double before = report.last_step;
    report.last_step = length * step_.lpNorm<Eigen::Infinity>();
    unsettled = system_.joints().unsettled(q_) || (limits.several && report.last_step > rough_step);
    const double rate = before > 0 ? std::min(1.0, report.last_step / before) : 1;
    if (!unsettled && rate * report.last_step < limits.enough) break;
  }
  // A step of nearly no length has converged, whatever the residual of a solve for rounding errors is.
  const double little = (report.residual < most_unsolved ? 1 : still_share) * limits.converged;
  report.converged = report.last_step < little && std::isfinite(report.residual);
  return report;
}

/// Corrects the momentum of a floating island for unfinished Newton and linear solves. Translating the whole
/// island changes inertia terms only.
void IslandSolver::keep_momentum(const Island& island, double h) {
  if (!floats(island)) return;
  system_.gradient(q_, g_);
  Vec3 force = Vec3::Zero();
  double inertia = 0;  // N/m
  for (std::size_t m = 0; m < island.soft.size(); ++m) {
    const soft::SoftBody& body = *island.soft[m].body;
    const soft::Stage& stage = body.stepper().stage();
    force += g_.segment(system_.layout().soft[m], 3 * body.nodes()).reshaped(3, body.nodes()).rowwise().sum();
    inertia += (stage.alpha + body.desc().material.damping_mass / stage.dxdv) * body.total_mass();
  }
  for (std::size_t m = 0; m < island.rigid.size(); ++m) {
    force += g_.segment<3>(system_.layout().rigid(m));
    inertia += island.rigid[m].mass / (h * h);
  }
  const Vec3 shift = -force / inertia;
  for (std::size_t m = 0; m < island.soft.size(); ++m) {
    const Eigen::Index nodes = island.soft[m].body->nodes();
    q_.segment(system_.layout().soft[m], 3 * nodes).reshaped(3, nodes).colwise() += shift;
  }
  for (std::size_t m = 0; m < island.rigid.size(); ++m) q_.segment<3>(system_.layout().rigid(m)) += shift;
}

/// Makes one attempt at the tick. Sets work_: J, by joints on each soft member.
IslandReport IslandSolver::attempt(Island& island, const Limits& limits, double h) {
  PROSECTOR_ASSERT(limits.solver != nullptr && limits.newton >= 0);
  const double tolerance = linear_tolerance(island, limits.settings.tolerance, bodies_);
  int stages = 1;
  for (const SoftMember& m : island.soft) stages = std::max(stages, stages_of(m));
  IslandReport report;
  work_.assign(island.soft.size(), 0);
  system_.begin(island, h);  // displacements are measured from here in every stage
  system_.start(start_);
  for (int stage = 0; stage < stages; ++stage) {
    parallel_each(island.soft.size(), [&](std::size_t i) {
      const SoftMember& m = island.soft[i];
      m.body->stepper().begin_stage(stage, h, m.weight, *m.state, m.euler);
    });
    system_.initial_guess(q_);
    if (limits.careful || (limits.alone && violent(island))) start_where_energy_is_least();
    IslandReport part = minimise(limits, tolerance);
    part.newton_iterations += report.newton_iterations;
    part.solver_iterations += report.solver_iterations;
    part.descended = part.descended && report.descended;
    report = part;
    if (!report.descended && limits.in_company) system_.energy(q_);
    if (limits.in_company) stored_ = system_.stored_in_tissue(q_) + system_.stored_in_joints(q_);
    keep_momentum(island, h);
    report.finite = q_.allFinite() && q_.lpNorm<Eigen::Infinity>() < max_coordinate;
    if (!report.finite) return report;
    for (std::size_t m = 0; m < island.rigid.size(); ++m)
      island.rigid[m].twist = q_.segment<6>(system_.layout().rigid(m));
    system_.joints().write_joint_forces(q_, limits.held);
    for (std::size_t m = 0; m < island.soft.size(); ++m) {
      soft::SoftBody& body = *island.soft[m].body;
      body.stepper().finish_stage(stage, h, q_.segment(system_.layout().soft[m], 3 * body.nodes()),
                                  *island.soft[m].state);
    }
    if (stage + 1 == stages) system_.joints().work(start_, q_, work_);
  }
  return report;
}

/// Sums up the island's energy over the last attempt.
IslandSolver::Account IslandSolver::account(const Island& island, double h) {
  Account sum{guard_.before(), 0, stored_};
  for (const SoftMember& m : island.soft) {
    sum.given +=
        soft::fall_energy(m.body->node_mass(), m.body->stepper().remembered().x, m.state->motion.x, m.weight);
    sum.has += soft::kinetic_energy(m.body->node_mass(), m.state->motion.v);
  }
  for (const RigidMember& m : island.rigid) {
    const auto product = [&](const Vec6& a, const Vec6& b) {
      return (m.mass * a.head<3>().dot(b.head<3>()) + a.tail<3>().dot(m.inertia * b.tail<3>())) / (h * h);
    };
    sum.had += product(m.steady, m.steady) / 2;
    sum.given += product(m.predicted - m.steady, m.twist);
    sum.has += product(m.twist, m.twist) / 2;
  }
  next_ = start_;  // after the rigid bodies' predicted displacement
  next_.tail(6 * static_cast<Eigen::Index>(island.rigid.size())).setZero();
  sum.had += system_.stored_in_joints(next_);
  return sum;
}

/// Returns whether the last attempt gained clearly more energy than gravity's work. A minimiser gains none;
/// an iterate that was stopped with large residual forces may.
bool IslandSolver::gained_in_company(const Island& island, double h) {
  double mass = 0;
  for (const SoftMember& m : island.soft) mass += m.body->total_mass();
  const Account sum = account(island, h);
  const double room = most_gain * sum.had + mass * small_speed * small_speed / 2;
  return !(sum.has <= sum.had + sum.given + room);
}

IslandReport IslandSolver::solve(Island& island, double h) {
  PROSECTOR_ASSERT(h > 0);
  Limits limits = limits_of(island);
  choose_integrators(island);
  guard_.begin(island);
  if (!guard_.sound()) {
    IslandReport lost;
    lost.finite = false;
    return lost;
  }
  IslandReport report = attempt(island, limits, h);
  const auto gained = [&] {
    if (limits.alone) return guard_.gained(work_);
    return limits.in_company && gained_in_company(island, h);
  };
  if (report.finite ? gained() : limits.alone) {
    guard_.rewind();
    limits.newton *= newton_with_care;
    if (limits.in_company) limits.settings.max_iterations *= solver_with_care;
    limits.careful = true;
    for (SoftMember& m : island.soft) m.euler = m.guarded = true;
    const IslandReport first = report;
    report = attempt(island, limits, h);
    report.newton_iterations += first.newton_iterations;
    report.solver_iterations += first.solver_iterations;
    if (!report.finite) {
      guard_.rewind();
      return report;
    }
    if (limits.alone && guard_.gained(work_)) {
      guard_.shorten(work_);
      report.converged = false;
    }
  }
  if (!report.finite) {
    guard_.rewind();
    return report;
  }
  if (limits.alone) guard_.finish(work_, h);
  for (SoftMember& m : island.soft)
    if (m.euler && m.body->stepper().integrator().remembers()) m.state->motion.has_history = false;
  return report;
}

}  // namespace prosector::coupled
