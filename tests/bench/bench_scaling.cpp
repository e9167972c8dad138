// Frame time against number of elements and threads.

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <cmath>

#include "server/calibration/stopwatch.h"
#include "server/physics/mechanics/soft/rungs.h"
#include "tests/bench/memory.h"
#include "tests/bench/rung_choices.h"
#include "tests/bench/rung_report.h"
#include "tests/bench/subjects.h"
#include "tests/bench/text_table.h"
#include "tests/soft/kuhn.h"

namespace prosector {
namespace {

constexpr double frame = 1. / 60;  // s
const Vec3 gravity(0, -9.81, 0);   // m/s²
constexpr int warm_up_frames = 2, frames = 5;
constexpr double liver = 0.2;  // m, length of the block

/// Returns a block of a liver's proportions and tissue, glued to a wall, with about that many tetrahedra.
TestPiece block(double tets) {
  const auto side = static_cast<std::uint32_t>(std::max(1.0, std::round(std::cbrt(tets / 6 / 1.5))));
  const auto length = std::max(1u, static_cast<std::uint32_t>(std::lround(tets / 6 / (side * side))));
  const SoftDesc tissue;
  TestPiece piece;
  piece.mesh = kuhn_box({length, side, side}, Vec3(liver, liver / 1.5, liver / 1.5));
  piece.youngs_modulus = tissue.material.youngs_modulus;
  piece.poisson_ratio = tissue.material.poisson_ratio;
  piece.density = tissue.material.density;
  piece.damping_mass = tissue.material.damping_mass;
  piece.damping_stiffness = tissue.material.damping_stiffness;
  piece.clamped_axis = 0;
  return piece;
}

ReportRow measure(const Rung& rung, const TestPiece& piece, unsigned threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  const std::size_t before = allocated_bytes();
  const auto specimen = make_specimen(rung, piece);
  std::vector<double> wall, cpu;
  double residual = 0;
  for (int i = 0; i < warm_up_frames + frames; ++i) {
    const double wall_start = wall_ms(), cpu_start = cpu_ms();
    residual = specimen->step(frame, gravity).residual;
    if (i < warm_up_frames) continue;
    wall.push_back(wall_ms() - wall_start);
    cpu.push_back(cpu_ms() - cpu_start);
  }
  ReportRow row = settings(rung);
  const auto tets = static_cast<double>(specimen->elements());
  row["tets"] = specimen->elements();
  row["nodes"] = specimen->node_mass().size();
  row["dt"] = frame;
  row["threads"] = threads;
  row["ms_per_frame"] = median(wall);
  row["cpu_ms_per_frame"] = median(cpu);
  row["steps_per_s"] = 1e3 / median(wall);
  row["cpu_us_per_tet"] = 1e3 * median(cpu) / tets;
  row["bytes_per_tet"] = static_cast<double>(allocated_bytes() - before) / tets;
  row["residual"] = residual;
  row["verdict"] = verdict_name(specimen->positions().allFinite() ? Verdict::survives : Verdict::fails);
  return row;
}

/// Returns every model with every element it supports, at a scene's default effort. Solvers are varied only
/// for the default model or the requested one, because other models differ only in assembly.
std::vector<Rung> rungs(const ScalingBenchOptions& options) {
  std::vector<Rung> out;
  for (const soft::ModelRow& model : soft::models()) {
    if (!options.model.empty() && options.model != model.name) continue;
    for (const std::string& element : element_names()) {
      const bool is_law = !model.position_based && !model.fabric;
      if (element != SoftDesc{}.configuration.element && !is_law) continue;
      for (const std::string& solver : solver_names()) {
        if (!options.solver.empty() && options.solver != solver) continue;
        const bool with_all_solvers = model.name == SoftDesc{}.configuration.model || !options.model.empty();
        if (options.solver.empty() && !with_all_solvers && solver != SoftDesc{}.configuration.solver)
          continue;
        if (model.position_based && solver != SoftDesc{}.configuration.solver)
          continue;  // has its own solver
        out.push_back({model.name, SoftDesc{}.configuration.integrator, solver, element});
      }
    }
  }
  return out;
}

}  // namespace

Report bench_scaling(const ScalingBenchOptions& options) {
  using enum Column::Kind;
  const TextTable table({{text, "model", "model", 28},
                         {text, "element", "element", 7},
                         {text, "solver", "solver", 9},
                         {count, "tets", "tets", 8},
                         {count, "nodes", "nodes", 8},
                         {count, "threads", "threads", 3},
                         {number, "ms_per_frame", "ms/frame", 9},
                         {number, "cpu_ms_per_frame", "CPU ms", 9},
                         {number, "cpu_us_per_tet", "CPU us/tet", 9},
                         {number, "bytes_per_tet", "bytes/tet", 9},
                         {number, "residual", "residual", 9}});
  table.print_header();
  Report report("scaling");
  for (const Rung& rung : rungs(options)) {
    double last_ms = 0;
    for (double tets = 100; tets <= options.max_tets * 1.01 && last_ms < options.limit_ms;
         tets *= std::sqrt(10)) {
      const TestPiece piece = block(tets);
      for (unsigned threads = 1; threads <= options.threads; threads *= 2) {
        report.add(measure(rung, piece, threads));
        table.print(report.rows().back());
        last_ms = figure(report.rows().back(), "cpu_ms_per_frame");
      }
    }
  }
  return report;
}

}  // namespace prosector
