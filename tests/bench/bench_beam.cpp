// The cantilever of other codes' published results: 0.4 × 0.1 × 0.1 m, clamped at x = 0, E = 2e5 Pa,
// ν = 0.4, 1000 kg/m³, under gravity from rest at t = 0 in steps of 1/60 s, no damping except implicit
// Euler's.

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <cmath>
#include <map>
#include <string>

#include "server/calibration/stopwatch.h"
#include "tests/bench/bullet_specimen.h"
#include "tests/bench/soft_run.h"
#include "tests/bench/subjects.h"
#include "tests/bench/text_table.h"
#include "tests/soft/kuhn.h"

namespace prosector {
namespace {

constexpr double h = 1. / 60;
constexpr int moving_frames = 120;
constexpr int settled_frames = 30;
constexpr int relaxation_frames = 600;  // maximum
const Vec3 gravity(0, -9.81, 0);
const Vec3 size(0.4, 0.1, 0.1);

struct Model {
  const char* name;
  double continuum;    // m: static −u_y of the tip face's centre, mesh-converged
  const char* bullet;  // Bullet's closest model
};
constexpr Model models[] = {{"fem_corotational", 0.1704, "bullet_deformable_linear"},
                            {"fem_neo_hookean_polynomial", 0.1712, "bullet_deformable_neo_hookean"}};
constexpr double youngs_modulus = 2e5, poisson_ratio = 0.4, density = 1000;
constexpr double enough_of_bullet = 20e3;  // ms of CPU

struct Solver {
  const char* element;
  SolverEffort effort;
  std::uint32_t most_cells = 100;  // cells across; larger meshes take seconds per frame
};
constexpr Solver solver_rows[] = {
    {"tet4", {"cg", 1, 1000, 1e-3}},          {"tet4", {"cg", 3, 60, 1e-3}},
    {"tet4", {"direct", 1, 60, 1e-3}, 6},     {"tet4", {"multigrid", 1, 60, 1e-3}},
    {"tet4", {"multigrid", 1, 60, 1e-2}},     {"tet4", {"multigrid", 1, 60, 0.05}},
    {"tet10", {"cg", 1, 1000, 1e-3}, 4},      {"tet10", {"multigrid", 1, 60, 1e-3}, 4},
    {"tet10", {"multigrid", 1, 60, 1e-2}, 4}, {"tet10", {"multigrid", 1, 60, 0.05}, 4}};

Anatomy mesh(std::uint32_t n) {
  return kuhn_anatomy({4 * n, n, n}, size);
}

SoftDesc beam(const Model& model, const Solver& solver) {
  SoftDesc desc;
  desc.name = "beam";
  desc.configuration.model = model.name;
  desc.configuration.element = solver.element;
  solver.effort.apply_to(desc);
  desc.material.youngs_modulus = youngs_modulus;
  desc.material.poisson_ratio = poisson_ratio;
  desc.material.density = density;
  desc.material.damping_mass = desc.material.damping_stiffness = 0;
  desc.attach.push_back(clamp_at(0, size / 2));
  return desc;
}

/// Returns the mean displacement of the nodes closest to the centre of the face x = 0.4 (one if n is even,
/// else four).
double tip_height(const soft::SoftBody& body, const VecX& x) {
  const auto& rest = body.anatomy().tets.positions;
  const Vec3 middle(size[0], size[1] / 2, size[2] / 2);
  double nearest = 1, sum = 0;
  int count = 0;
  for (const Vec3& p : rest) nearest = std::min(nearest, (p - middle).norm());
  for (std::size_t i = 0; i < rest.size(); ++i) {
    if ((rest[i] - middle).norm() > nearest + 1e-9) continue;
    sum += x[static_cast<Eigen::Index>(3 * i + 1)];
    ++count;
  }
  return sum / count;
}

/// Converged solution of the same mesh: every step is solved to convergence.
struct Converged {
  double sag = 0;          // m, static deflection
  std::vector<VecX> path;  // positions after each frame of the motion
};

Converged converge(const Model& model, const char* element, std::uint32_t n) {
  SoftRun run(beam(model, {element, {"multigrid", 30, 2000, 1e-8}}), mesh(n));
  Converged result;
  for (int i = 0; i < moving_frames; ++i) {
    run.step(h, gravity);
    result.path.push_back(run.state().motion.x);
  }
  run.settle(0.5, gravity, 100);
  result.sag = size[1] / 2 - tip_height(run.body(), run.state().motion.x);
  return result;
}

ReportRow measure(const Model& model, const Solver& solver, std::uint32_t n, const Converged& converged) {
  SoftRun run(beam(model, solver), mesh(n));
  const VecX rest = run.state().motion.x;
  CostSummary moving, settled;
  double off = 0, all = 0;
  for (const VecX& there : converged.path) {
    moving.add(run.step(h, gravity));
    off += (run.state().motion.x - there).squaredNorm();
    all += (there - rest).squaredNorm();
  }
  run.settle(h, gravity, relaxation_frames);
  for (int i = 0; i < settled_frames; ++i) settled.add(run.step(h, gravity));
  const double sag = size[1] / 2 - tip_height(run.body(), run.state().motion.x);
  ReportRow row = settings(run.body(), h);
  row.update(figures(moving));
  row["ms_per_frame_settled"] = settled.median_ms();
  row["sag_m"] = sag;
  row["error_mesh"] = std::abs(sag / converged.sag - 1);
  row["error_continuum"] = std::abs(sag / model.continuum - 1);
  row["error_dynamic"] = std::sqrt(off / all);
  row["verdict"] = verdict_name(run.finite() ? Verdict::survives : Verdict::fails);
  return row;
}

/// Measures Bullet's deformable body on the same mesh, moving. Bullet was also measured on the machine of the
/// other codes, so this relates the two machines.
ReportRow measure_bullet(const Model& model, std::uint32_t n) {
  TestPiece piece;
  piece.mesh = mesh(n).tets;
  piece.youngs_modulus = youngs_modulus;
  piece.poisson_ratio = poisson_ratio;
  piece.density = density;
  piece.clamped_axis = 0;
  const BulletRung rung = {model.bullet, 0};
  const auto specimen = make_specimen(rung, piece);
  CostSummary moving;
  double spent = 0;
  for (int i = 0; i < moving_frames && spent < enough_of_bullet; ++i) {
    StepCost cost;
    const double wall = wall_ms(), cpu = cpu_ms();
    cost.residual = specimen->step(h, gravity).residual;
    cost.cpu_ms = cpu_ms() - cpu;
    cost.wall_ms = wall_ms() - wall;
    spent += cost.cpu_ms;
    moving.add(cost);
  }
  ReportRow row = settings(rung);
  row["tets"] = piece.mesh.tets.size();
  row["nodes"] = piece.mesh.positions.size();
  row["dt"] = h;
  row["threads"] = 1;
  row["ms_per_frame"] = moving.median_ms();
  row["cpu_ms_per_frame"] = moving.cpu_ms();
  row["steps_per_s"] = 1e3 / moving.median_ms();
  row["verdict"] = verdict_name(specimen->positions().allFinite() ? Verdict::survives : Verdict::fails);
  return row;
}

}  // namespace

Report bench_beam(const BeamBenchOptions& options) {
  fmt::print(
      "ms per frame: median wall time, moving and settled; cpu: all threads; errors: static solution against "
      "this mesh's\nand the continuum's; dynamic: RMS over the first {} frames\n",
      moving_frames);
  using enum Column::Kind;
  const TextTable table({{text, "model", "model", 27},
                         {text, "element", "elem"},
                         {text, "solver", "solver", 9},
                         {count, "newton_iterations", "N"},
                         {count, "solver_iterations", "max. it."},
                         {number, "solver_tolerance", "to"},
                         {count, "tets", "tets", 6},
                         {count, "threads", "T"},
                         {number, "ms_per_frame", "ms", 6},
                         {number, "ms_per_frame_settled", "settled", 6},
                         {number, "cpu_ms_per_frame", "cpu", 6},
                         {number, "iterations_per_frame", "iter", 5},
                         {number, "residual", "residual", 8},
                         {percent, "error_mesh", "mesh", 8},
                         {percent, "error_continuum", "continuum", 8},
                         {percent, "error_dynamic", "dynamic", 8}});
  table.print_header();
  Report report("beam");
  for (const Model& model : models) {
    if (!options.model.empty() && options.model != model.name) continue;
    for (const std::uint32_t n : options.cells) {
      std::map<std::string, Converged> converged;  // per element
      for (const Solver& solver : solver_rows) {
        if (!options.solver.empty() && options.solver != solver.effort.name) continue;
        if (n > solver.most_cells) continue;
        if (!options.element.empty() && options.element != solver.element) continue;
        if (!converged.contains(solver.element))
          converged[solver.element] = converge(model, solver.element, n);
        for (unsigned threads = 1; threads <= options.threads; ++threads) {
          const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
          report.add(measure(model, solver, n, converged[solver.element]));
          table.print(report.rows().back());
        }
      }
      if (!options.solver.empty() || options.element == "tet10") continue;
      report.add(measure_bullet(model, n));
      table.print(report.rows().back());
    }
  }
  return report;
}

}  // namespace prosector
