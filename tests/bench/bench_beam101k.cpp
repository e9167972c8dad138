// SOFA's published benchmark beam (TetrahedronFEMForceField_beam16x16x76): 76 × 16 × 16 nodes over the box
// (0, 6, −2) … (19, 10, 2), each cell in six tetrahedra, total mass 50 (lumped ρV/4 here), E = 1000, ν = 0.3,
// gravity (0, −9, 0), face x = 0 fixed, Rayleigh damping 0.1 and 0.1, implicit Euler of 0.04 s; with and
// without the ground plane y = 2 (penalty stiffness 1e4).

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <cmath>

#include "tests/bench/soft_run.h"
#include "tests/bench/subjects.h"
#include "tests/bench/text_table.h"
#include "tests/soft/kuhn.h"

namespace prosector {
namespace {

constexpr double h = 0.04;
constexpr double ground = 2, ground_stiffness = 1e4;
const Vec3 gravity(0, -9, 0), corner(0, 6, -2), size(19, 4, 4);

constexpr SolverEffort reference = {"multigrid", 20, 2000, 1e-7};
constexpr SolverEffort solver_rows[] = {{"cg", 1, 10, 1e-6},        {"cg", 1, 200, 1e-3},
                                        {"multigrid", 1, 60, 0.05}, {"multigrid", 1, 60, 1e-2},
                                        {"multigrid", 2, 60, 0.3},  {"multigrid", 2, 60, 0.1}};

Anatomy mesh() {
  Anatomy anatomy = kuhn_anatomy({75, 15, 15}, size);
  for (Vec3& p : anatomy.tets.positions) p += corner;
  return anatomy;
}

SoftDesc beam(const SolverEffort& solver) {
  SoftDesc desc;
  desc.name = "beam101k";
  desc.configuration.model = "fem_corotational";
  solver.apply_to(desc);
  desc.material.youngs_modulus = 1000;
  desc.material.poisson_ratio = 0.3;
  desc.material.density = 50 / size.prod();
  desc.material.damping_mass = desc.material.damping_stiffness = 0.1;
  desc.geometry.cell = 0.25;
  desc.attach.push_back(clamp_at(0, corner + size / 2));
  return desc;
}

double tip_height(const soft::SoftBody& body, const VecX& x) {
  const auto& rest = body.anatomy().tets.positions;
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    if (rest[i].x() < size[0] - 1e-9) continue;
    sum += x[static_cast<Eigen::Index>(3 * i + 1)];
    ++count;
  }
  return sum / count;
}

/// Returns contacts of all nodes that may reach the ground within the step.
std::vector<contact::Contact> ground_contacts(const VecX& x, const VecX& v) {
  std::vector<contact::Contact> contacts;
  for (Eigen::Index i = 0; i < x.size() / 3; ++i) {
    const double gap = x[3 * i + 1] - ground;
    if (gap > 2 * h * std::abs(v[3 * i + 1]) + 0.05) continue;
    contacts.push_back(node_contact(x, i, Vec3::UnitY(), gap, ground_stiffness));
  }
  return contacts;
}

struct Path {
  ReportRow settings;
  std::vector<double> tip;  // m
  CostSummary cost;
  bool finite = true;
};

Path run(const SolverEffort& solver, bool with_ground, int steps) {
  SoftRun run(beam(solver), mesh());
  Path path;
  path.settings = settings(run.body(), h);
  for (int i = 0; i < steps; ++i) {
    const soft::Motion& motion = run.state().motion;
    path.cost.add(run.step(
        h, gravity, with_ground ? ground_contacts(motion.x, motion.v) : std::vector<contact::Contact>{}));
    path.tip.push_back(tip_height(run.body(), motion.x));
  }
  path.finite = run.finite();
  return path;
}

/// Returns the RMS path error of the tip, relative to its RMS displacement.
double path_error(const Path& path, const Path& converged) {
  double off = 0, all = 0;
  for (std::size_t i = 0; i < path.tip.size(); ++i) {
    const double start = corner[1] + size[1] / 2;
    off += std::pow(path.tip[i] - converged.tip[i], 2);
    all += std::pow(converged.tip[i] - start, 2);
  }
  return std::sqrt(off / all);
}

}  // namespace

Report bench_beam101k(const Beam101kBenchOptions& options) {
  fmt::print("steps/s: wall clock, median of {} steps; cpu: all threads; error: RMS of the tip's path\n",
             options.steps);
  using enum Column::Kind;
  const TextTable table = path_table({{count, "ground", "ground"}}, {number, "tip_m", "tip m"});
  table.print_header();
  Report report("beam101k");
  for (const bool with_ground : {false, true}) {
    const Path converged = run(reference, with_ground, options.steps);
    for (const SolverEffort& solver : solver_rows) {
      if (!options.solver.empty() && options.solver != solver.name) continue;
      for (unsigned threads = 1; threads <= options.threads; ++threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        const Path path = run(solver, with_ground, options.steps);
        ReportRow row = path.settings;
        row["ground"] = with_ground ? 1 : 0;
        row.update(figures(path.cost));
        row["error_mesh"] = path_error(path, converged);
        row["tip_m"] = path.tip.back();
        row["verdict"] = verdict_name(path.finite ? Verdict::survives : Verdict::fails);
        report.add(std::move(row));
        table.print(report.rows().back());
      }
    }
  }
  return report;
}

}  // namespace prosector
