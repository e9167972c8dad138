// An organ in contact: a block of 0.16 × 0.08 × 0.12 m of soft tissue (E = 5 kPa, ν = 0.4) in linear
// tetrahedra (31,104 with 12 cells through its thickness), its underside held. A ball of 30 mm presses it 24
// mm deep within 0.5 s, holds for 0.25 s and is withdrawn in 0.5 s. Steps of 1/60 s.

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <cmath>
#include <numbers>

#include "tests/bench/soft_run.h"
#include "tests/bench/subjects.h"
#include "tests/bench/text_table.h"
#include "tests/soft/kuhn.h"

namespace prosector {
namespace {

constexpr double h = 1. / 60, radius = 0.03, depth = 0.024;
constexpr int down_steps = 30, held_steps = 15, all_steps = 2 * down_steps + held_steps;
constexpr double stiff = 10;     // contact stiffness over (E · cell size)
constexpr double margin = 0.01;  // m: nodes within this distance get a contact
const Vec3 gravity(0, -9.81, 0), size(0.16, 0.08, 0.12);

constexpr SolverEffort reference = {"multigrid", 30, 2000, 1e-7};
constexpr SolverEffort solver_rows[] = {
    {"cg", 1, 20, 1e-3},        {"cg", 1, 60, 1e-3},        {"cg", 2, 20, 1e-2},
    {"cg", 2, 60, 1e-3},        {"cg", 3, 60, 1e-3},        {"multigrid", 1, 60, 1e-3},
    {"multigrid", 2, 60, 0.1},  {"multigrid", 2, 60, 1e-2}, {"multigrid", 2, 60, 1e-3},
    {"multigrid", 3, 60, 1e-3},
};

SoftDesc organ(const SolverEffort& solver, unsigned cells) {
  SoftDesc desc;
  desc.name = "organ";
  desc.configuration.model = "fem_corotational";
  solver.apply_to(desc);
  desc.material.youngs_modulus = 5000;
  desc.material.poisson_ratio = 0.4;
  desc.geometry.cell = size[1] / cells;
  desc.gravity = false;  // starts undeformed at rest
  constexpr double sphere = 1e5;
  desc.attach.push_back({Vec3(size[0] / 2, -sphere, size[2] / 2), sphere + 1e-4, 1e13});
  return desc;
}

/// Returns the depth of the ball's lowest point below the organ's top after `step` steps, m.
double pressed(int step) {
  const int from_end = std::min(step, all_steps - step);
  const double phase = std::min(1.0, static_cast<double>(from_end) / down_steps);
  return depth * (1 - std::cos(std::numbers::pi * phase)) / 2;
}

Anatomy block(unsigned cells) {
  return kuhn_anatomy({2 * cells, cells, 3 * cells / 2}, size);
}

std::vector<contact::Contact> ball_contacts(const soft::SoftBody& body, const VecX& x, int step) {
  const Vec3 center(size[0] / 2, size[1] - pressed(step) + radius, size[2] / 2);
  std::vector<contact::Contact> contacts;
  for (Eigen::Index i = 0; i < x.size() / 3; ++i) {
    const Vec3 away = x.segment<3>(3 * i) - center;
    const double gap = away.norm() - radius;
    if (gap > margin || away.norm() == 0) continue;
    contacts.push_back(node_contact(x, i, away.normalized(), gap,
                                    stiff * body.desc().material.youngs_modulus * body.desc().geometry.cell));
  }
  return contacts;
}

struct Path {
  ReportRow settings;
  std::vector<VecX> x;
  CostSummary cost;
  std::size_t most_contacts = 0;
  double deepest = 0;  // m, largest downward displacement of a node
  bool finite = true;
};

Path run(const SolverEffort& solver, unsigned cells) {
  SoftRun run(organ(solver, cells), block(cells));
  const VecX rest = run.state().motion.x;
  Path path;
  path.settings = settings(run.body(), h);
  for (int step = 1; step <= all_steps; ++step) {
    std::vector<contact::Contact> contacts = ball_contacts(run.body(), run.state().motion.x, step);
    path.most_contacts = std::max(path.most_contacts, contacts.size());
    path.cost.add(run.step(h, gravity, std::move(contacts)));
    path.x.push_back(run.state().motion.x);
    path.deepest = std::max(path.deepest, (rest - path.x.back()).maxCoeff());
  }
  path.finite = run.finite();
  return path;
}

/// Returns the RMS error over all nodes and steps, relative to the RMS displacement.
double path_error(const Path& path, const Path& converged, const VecX& rest) {
  double off = 0, all = 0;
  for (std::size_t i = 0; i < path.x.size(); ++i) {
    off += (path.x[i] - converged.x[i]).squaredNorm();
    all += (converged.x[i] - rest).squaredNorm();
  }
  return std::sqrt(off / all);
}

}  // namespace

Report bench_press(const PressBenchOptions& options) {
  fmt::print(
      "steps/s: wall clock, median of {} steps; cpu: all threads; error: RMS over all nodes and steps\n",
      all_steps);
  using enum Column::Kind;
  const TextTable table = path_table({}, {number, "deepest_m", "deepest"});
  table.print_header();
  Report report("press");
  const VecX rest =
      soft::SoftBody(organ(reference, options.cells), block(options.cells)).initial_state().motion.x;
  const Path converged = run(reference, options.cells);
  for (const SolverEffort& solver : solver_rows) {
    if (!options.solver.empty() && options.solver != solver.name) continue;
    for (unsigned threads = 1; threads <= options.threads; ++threads) {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      const Path path = run(solver, options.cells);
      ReportRow row = path.settings;
      row["contacts_at_most"] = path.most_contacts;
      row.update(figures(path.cost));
      row["error_mesh"] = path_error(path, converged, rest);
      row["deepest_m"] = path.deepest;
      row["verdict"] = verdict_name(path.finite ? Verdict::survives : Verdict::fails);
      report.add(std::move(row));
      table.print(report.rows().back());
    }
  }
  return report;
}

}  // namespace prosector
