#include "server/physics/coupled/island_solver.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "server/physics/parallel.h"
#include "server/physics/soft/base/effort.h"
#include "server/physics/soft/implicit_stepper.h"
#include "server/physics/soft/mechanical_energy.h"

namespace prosector {
namespace {

constexpr int rigid_newton_iterations = 12;
constexpr double enough_step =
    1e-5;  // m: a next Newton step below it, at the rate of the last two, is not taken
constexpr double enough_share = 0.05;   // of the slip over which friction builds up, where it holds
constexpr double enough_size = 6e-5;    // of a small body's diagonal, or if that is more, …
constexpr double enough_square = 4e-3;  // … 1/m, of its square: from 5 cm on, enough_step
constexpr double converged_steps = 10;  // of those that are enough: what is left then is little
constexpr double most_unsolved = 0.3;   // of the forces, where a step is to count …
constexpr double still_share = 0.01;    // … that is not so short
constexpr double rough_step = 3e-3;  // m: what still moves so far among several soft bodies may gain energy
constexpr int halvings = 12, halvings_with_care = 40;
constexpr int newton_until_settled = 4;  // times the scene's iterations, at most, where contacts change
constexpr int newton_with_care = 4;      // times the scene's iterations
constexpr int solver_with_care = 4;      // times the scene's iterations, in company
constexpr double most_gain = 0.12;       // in company: of what an island has, a tick, …
constexpr double small_speed = 0.02;     // … and m/s, that of its tissue
constexpr double violent_step = 0.1;     // diagonals of a body that its warm start may lead away
constexpr double armijo = 1e-4;
constexpr const char* rigid_solver = "cg";  // of islands without a soft body
constexpr double rounding = 1e-12;          // of |E|: what a sum of this size cannot resolve

/// Tells whether rigid bodies bear each other on tissue. Those count that nothing pulls, and that tissue
/// moves, be it through others: a hand is where it is pulled to, and what it pushes aside tissue doesn't know
/// of.
bool borne_by_tissue(const Island& island, std::vector<BorneBody>& bodies) {
  bodies.clear();
  for (const RigidMember& m : island.rigid)
    if (!m.pull) bodies.push_back({m.slot, false});
  std::sort(bodies.begin(), bodies.end(), [](const auto& a, const auto& b) { return a.slot < b.slot; });
  const auto find = [&](const ContactSide& side) {
    if (side.kind != ContactSide::Kind::rigid) return bodies.end();
    const auto at =
        std::lower_bound(bodies.begin(), bodies.end(), side.body,
                         [](const BorneBody& body, std::size_t slot) { return body.slot < slot; });
    return at != bodies.end() && at->slot == side.body ? at : bodies.end();
  };
  bool more = !bodies.empty();
  const auto spread = [&](const ContactSide& from, const ContactSide& to) {
    const auto giver = find(from), taker = find(to);
    if (taker == bodies.end() || taker->on_tissue) return;
    if (from.kind == ContactSide::Kind::soft || (giver != bodies.end() && giver->on_tissue))
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
  const auto borne = [&](const ContactSide& side) {
    const auto known = find(side);
    return known != bodies.end() && known->on_tissue;
  };
  return std::any_of(island.contacts.begin(), island.contacts.end(), [&](const Contact& c) {
    return c.a.kind != ContactSide::Kind::soft && (borne(c.a) || borne(c.b));
  });
}

/// Returns the linear solver's tolerance, as inexact Newton has it (Dembo, Eisenstat and Steihaug 1982). What
/// a tighter solve of the first of several linearisations would gain, the next one changes again. It stays
/// tight where rigid bodies bear each other: errors there are pushes, and light bodies under heavy ones
/// drift.
double linear_tolerance(const Island& island, double tolerance, std::vector<BorneBody>& bodies) {
  const bool borne = island.soft.empty() ? !island.contacts.empty() : borne_by_tissue(island, bodies);
  return borne ? tolerance : std::sqrt(tolerance);
}

/// Returns the step, m, below which nothing more is solved, by size: what is small moves by less than what is
/// large. Bodies of 5 cm and more, and rigid bodies, have enough_step.
double enough_for_size(const Island& island) {
  double enough = enough_step;
  for (const SoftMember& m : island.soft) {
    const double diagonal = m.body->diagonal();
    enough = std::min(enough, std::max(enough_size * diagonal, enough_square * diagonal * diagonal));
  }
  return enough;
}

/// Returns the step, m, below which nothing more is solved. What holds by friction moves by less than its
/// threshold: steps that don't resolve that would leave it to tremble, and to creep.
double enough(const Island& island) {
  const bool rough = std::any_of(island.contacts.begin(), island.contacts.end(),
                                 [](const Contact& c) { return c.friction > 0; });
  const double by_size = enough_for_size(island);
  return rough ? std::min(by_size, enough_share * slip_threshold) : by_size;
}

/// Tells whether the warm start of some soft body leads so far that it may be worse than none.
bool violent(const Island& island) {
  return std::any_of(island.soft.begin(), island.soft.end(), [](const SoftMember& m) {
    return m.state->warm_start.lpNorm<Eigen::Infinity>() > violent_step * m.body->diagonal();
  });
}

int stages_of(const SoftMember& m) {
  return m.euler ? 1 : m.body->stepper().integrator().stages();
}

/// Tells whether some body keeps a history of stress. What it gives back is no gain.
bool relaxing(const Island& island) {
  return std::any_of(island.soft.begin(), island.soft.end(),
                     [](const SoftMember& m) { return m.state->history.size() > 0; });
}

/// Tells whether the island has soft bodies and all are of tetrahedra. Sheets and ropes are so light that
/// what they touch gives them any share of what they have.
bool solid(const Island& island) {
  return !island.soft.empty() && std::all_of(island.soft.begin(), island.soft.end(), [](const SoftMember& m) {
    return !m.body->linear_tets().tets.empty();
  });
}

/// Chooses implicit Euler for all soft bodies in company of rigid or other soft ones, so that what one loses
/// the other gets. Methods of several steps or stages weigh a force otherwise than a rigid body does over the
/// same tick.
void choose_integrators(Island& island) {
  for (SoftMember& m : island.soft) m.euler = !island.rigid.empty() || island.soft.size() > 1;
}

/// Tells whether nothing holds the island in the room.
bool floats(const Island& island) {
  const auto to_room = [](const auto& joint) {
    return joint.a.kind == ContactSide::Kind::fixed || joint.b.kind == ContactSide::Kind::fixed;
  };
  return std::none_of(island.contacts.begin(), island.contacts.end(), to_room) &&
         std::none_of(island.ties.begin(), island.ties.end(), to_room) &&
         std::none_of(island.soft.begin(), island.soft.end(),
                      [](const SoftMember& m) { return m.body->attached(); }) &&
         std::none_of(island.rigid.begin(), island.rigid.end(),
                      [](const RigidMember& m) { return m.pull.has_value(); });
}

/// Tells whether nothing in the island moves freely.
bool all_held(const Island& island) {
  return !floats(island) && std::all_of(island.rigid.begin(), island.rigid.end(),
                                        [](const RigidMember& m) { return m.pull.has_value(); });
}

}  // namespace

struct IslandSolver::Limits {
  int newton = rigid_newton_iterations;
  bool alone = true;        // nothing touches or holds: each body's energy is watched
  bool in_company = false;  // else the island's is, but for what has a history of stress or is driven
  bool several = false;     // soft bodies
  bool held = false;        // nothing moves freely: no momentum has to add up
  bool careful = false;     // exact tangents from the first on, long searches
  double enough = enough_step, converged = converged_steps * enough_step;  // m, of Newton's steps
  SolverSettings settings;
  LinearSolver* solver = nullptr;
};

IslandSolver::Limits IslandSolver::limits_of(const Island& island) {
  Limits limits;
  const bool soft = !island.soft.empty();
  const std::string name = soft ? island.soft.front().body->desc().solver : rigid_solver;
  std::unique_ptr<LinearSolver>& solver = solvers_[name];
  if (!solver) solver = make_solver(name);
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
  const Effort effort = effort_of(island.soft.front().body->desc(), steps_down);
  limits.newton = effort.newton_iterations;
  limits.settings = {effort.solver_iterations, effort.solver_tolerance};
  return limits;
}

/// Returns the largest step length 1, ½, ¼ … that lowers the energy enough; 0 when none does. next_ and the
/// system's last energy are then those of that length.
double IslandSolver::line_search(double energy, double slope, int halvings) {
  double length = 1;
  for (int i = 0; i < halvings; ++i, length /= 2) {
    next_ = q_ + length * step_;
    const double there = system_.energy(next_);
    if (std::isfinite(there) && there <= energy + armijo * length * slope + rounding * std::abs(energy))
      return length;
  }
  return 0;
}

/// Starts at q_, or where the tick began, where the energy is less.
void IslandSolver::start_where_energy_is_least() {
  const double there = system_.energy(q_), here = system_.energy(start_);
  if (!std::isfinite(there) || here < there)
    q_ = start_;
  else
    system_.energy(q_);
}

/// Minimises the energy from q_ on; leaves the result in q_.
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
    SolveReport solved =
        limits.solver->solve(system_, right_, {limits.settings.max_iterations, tolerance}, solved_);
    report.solver_iterations += solved.iterations;
    system_.expand(g_, solved_, step_);
    if (report.newton_iterations++ == 0 && step_.lpNorm<Eigen::Infinity>() < limits.converged) {
      // Close to rest: this one is the last.
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
    // A matrix kept misleads here; beside others, who touches whom may as well have changed.
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
  // What does not move at all is as good as it gets: of forces that are rounding, solvers leave any share.
  const double little = (report.residual < most_unsolved ? 1 : still_share) * limits.converged;
  report.converged = report.last_step < little && std::isfinite(report.residual);
  return report;
}

/// Corrects the momentum of what floats, whatever Newton's method and the linear solver left undone. Moved as
/// a whole, the island costs nothing but inertia.
void IslandSolver::keep_momentum(const Island& island, double h) {
  if (!floats(island)) return;
  system_.gradient(q_, g_);
  Vec3 force = Vec3::Zero();
  double inertia = 0;  // N/m
  for (std::size_t m = 0; m < island.soft.size(); ++m) {
    const SoftBody& body = *island.soft[m].body;
    const Stage& stage = body.stepper().stage();
    force += g_.segment(system_.layout().soft[m], 3 * body.nodes()).reshaped(3, body.nodes()).rowwise().sum();
    inertia += (stage.alpha + body.desc().damping_mass / stage.dxdv) * body.total_mass();
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

/// Makes one attempt at the tick. work_: J, by joints on each soft member.
IslandReport IslandSolver::attempt(Island& island, const Limits& limits, double h) {
  const double tolerance = linear_tolerance(island, limits.settings.tolerance, bodies_);
  int stages = 1;
  for (const SoftMember& m : island.soft) stages = std::max(stages, stages_of(m));
  IslandReport report;
  work_.assign(island.soft.size(), 0);
  system_.begin(island, h);  // displacements count from here, in every stage
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
    system_.joints().tell_joints(q_, limits.held);
    for (std::size_t m = 0; m < island.soft.size(); ++m) {
      SoftBody& body = *island.soft[m].body;
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
        fall_energy(m.body->node_mass(), m.body->stepper().remembered().x, m.state->motion.x, m.weight);
    sum.has += kinetic_energy(m.body->node_mass(), m.state->motion.v);
  }
  for (const RigidMember& m : island.rigid) {
    const auto product = [&](const Vec6& a, const Vec6& b) {
      return (m.mass * a.head<3>().dot(b.head<3>()) + a.tail<3>().dot(m.inertia * b.tail<3>())) / (h * h);
    };
    sum.had += product(m.steady, m.steady) / 2;
    sum.given += product(m.predicted - m.steady, m.twist);
    sum.has += product(m.twist, m.twist) / 2;
  }
  next_ = start_;  // where rigid bodies have fallen already
  next_.tail(6 * static_cast<Eigen::Index>(island.rigid.size())).setZero();
  sum.had += system_.stored_in_joints(next_);
  return sum;
}

/// Tells whether the last attempt gave the island more energy than weight did, and not by a little. A
/// minimiser gives none; an iterate that was stopped while much of the forces was left may.
bool IslandSolver::gained_in_company(const Island& island, double h) {
  double mass = 0;
  for (const SoftMember& m : island.soft) mass += m.body->total_mass();
  const Account sum = account(island, h);
  const double room = most_gain * sum.had + mass * small_speed * small_speed / 2;
  return !(sum.has <= sum.had + sum.given + room);
}

IslandReport IslandSolver::solve(Island& island, double h) {
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

}  // namespace prosector
