// A cube of 0.1 m and a slab of 0.2 × 0.06 × 0.2 m stand on a glued foot or hang from it. The static shape of
// each mesh is compared with a finer quadratic mesh, graded twice at the foot's rim. Ticks are timed while
// gravity is switched on.

#include <fmt/format.h>

#include <cmath>

#include "server/accuracy/displacement.h"
#include "server/physics/stations/compile/grading.h"
#include "tests/bench/soft_run.h"
#include "tests/bench/subjects.h"
#include "tests/bench/weighed_body.h"
#include "tests/soft/kuhn.h"

namespace prosector {
namespace {

constexpr double weighing_step = 1. / 60;
constexpr int weighing_ticks = 45;
constexpr std::size_t weighing_places = 250;

struct WeighedMesh {
  const char* element;
  Cells cells;
  Grading grade = Grading::none;
};
struct WeighedRow {
  WeighedBody body;
  Cells reference;
  std::vector<WeighedMesh> meshes;
};

std::vector<WeighedRow> weighed_rows() {
  return {{weighed_cube,
           {7, 7, 7},
           {{"tet4", {6, 6, 6}},
            {"tet4", {9, 9, 9}},
            {"tet10", {2, 2, 2}},
            {"tet10", {3, 3, 3}},
            {"tet10", {4, 4, 4}},
            {"tet10", {6, 6, 6}},
            {"tet10", {2, 2, 2}, Grading::rims},
            {"tet10", {3, 3, 3}, Grading::rims},
            {"tet10", {4, 4, 4}, Grading::rims}}},
          {weighed_slab,
           {10, 4, 10},
           {{"tet4", {10, 4, 10}},
            {"tet4", {14, 6, 14}},
            {"tet10", {4, 2, 4}},
            {"tet10", {5, 2, 5}},
            {"tet10", {7, 3, 7}},
            {"tet10", {10, 4, 10}},
            {"tet10", {4, 2, 4}, Grading::rims},
            {"tet10", {5, 2, 5}, Grading::rims},
            {"tet10", {7, 3, 7}, Grading::rims}}}};
}

SoftDesc described(const WeighedRow& row, const WeighedMesh& mesh, double poisson_ratio) {
  SoftDesc desc = weighed_desc(row.body, mesh.element, poisson_ratio);
  desc.geometry.grade = mesh.grade;
  return desc;
}

Anatomy meshed(const WeighedRow& row, const WeighedMesh& mesh, const SoftDesc& desc) {
  Anatomy uniform = kuhn_anatomy(mesh.cells, row.body.size);
  return desc.geometry.grade == Grading::rims ? graded_at_rims(desc, std::move(uniform)) : uniform;
}

/// Returns the description of the body with the solver settings of timed ticks.
SoftDesc stepped(const WeighedRow& row, const WeighedMesh& mesh, double poisson_ratio) {
  SoftDesc desc = described(row, mesh, poisson_ratio);
  desc.configuration.solver = "multigrid";
  desc.configuration.solver_tolerance = 1e-2;
  desc.geometry.cell = row.body.size[0] / mesh.cells[0];
  return desc;
}

Weighed at_rest(const WeighedRow& row, const WeighedMesh& mesh, double poisson_ratio, double gravity) {
  const SoftDesc desc = described(row, mesh, poisson_ratio);
  return {desc, meshed(row, mesh, desc), gravity};
}

Weighed reference_at_rest(const WeighedRow& row, Cells cells, double poisson_ratio, double gravity) {
  const WeighedMesh once = {"tet10", cells, Grading::rims};
  const SoftDesc desc = described(row, once, poisson_ratio);
  return {desc, graded_at_rims(desc, meshed(row, once, desc)), gravity};
}

ReportRow weigh(const WeighedRow& weighed, const WeighedMesh& mesh, double poisson_ratio, double gravity,
                const Weighed& reference) {
  const SoftDesc desc = stepped(weighed, mesh, poisson_ratio);
  SoftRun run(desc, meshed(weighed, mesh, desc));
  ReportRow row = settings(run.body(), weighing_step);
  CostSummary cost;
  for (int i = 0; i < weighing_ticks; ++i) cost.add(run.step(weighing_step, {0, gravity, 0}));
  row["body"] = weighed.body.name;
  row["grade"] = grading_names[static_cast<std::size_t>(mesh.grade)];
  row["act"] = gravity < 0 ? "stands" : "hangs";
  row["poisson_ratio"] = poisson_ratio;
  row.update(figures(cost));
  row["ms_per_frame"] = cost.cpu_ms();
  const Weighed found = at_rest(weighed, mesh, poisson_ratio, gravity);
  row["error"] = nullptr;
  if (!found.answer.usable() || !reference.answer.usable()) return row;
  const std::vector<Vec3> places = places_in(reference.body.mesh(), weighing_places);
  row["error"] = relative_difference(Probes(found.body, places), found.answer.x,
                                     Probes(reference.body, places), reference.answer.x, places.size());
  return row;
}

}  // namespace

Report bench_weight(const WeightBenchOptions& options) {
  fmt::print("error: RMS of displacements at rest against a finer quadratic mesh; CPU: median per tick\n");
  using enum Column::Kind;
  const TextTable table({{text, "body", "body", 5},
                         {text, "act", "act", 6},
                         {number, "poisson_ratio", "nu", 7},
                         {text, "element", "element", 7},
                         {text, "grade", "grade", 5},
                         {count, "tets", "tets"},
                         {percent, "error", "error", 8},
                         {number, "ms_per_frame", "CPU ms", 8},
                         {number, "newton_per_frame", "Newton"},
                         {number, "iterations_per_frame", "solver"}});
  table.print_header();
  Report report("weight");
  for (const WeighedRow& weighed : weighed_rows()) {
    if (!options.body.empty() && options.body != weighed.body.name) continue;
    for (const double poisson_ratio : {0.3, 0.45, 0.49, 0.499, 0.4999}) {
      if (options.poisson_ratio > 0 && options.poisson_ratio != poisson_ratio) continue;
      for (const double gravity : {-9.81, 9.81}) {
        const Weighed reference = reference_at_rest(
            weighed, options.quick ? Cells{2, 1, 2} : weighed.reference, poisson_ratio, gravity);
        for (const WeighedMesh& mesh : weighed.meshes) {
          if (options.quick && &mesh != &weighed.meshes[2]) continue;
          report.add(weigh(weighed, mesh, poisson_ratio, gravity, reference));
          table.print(report.rows().back());
        }
      }
    }
  }
  return report;
}

}  // namespace prosector
