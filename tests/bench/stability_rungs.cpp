#include "tests/bench/stability_rungs.h"

#include <fmt/format.h>

#include <algorithm>

#include "server/physics/soft/constitutive_law.h"
#include "server/physics/soft/rungs.h"
#include "server/physics/soft/time_integrator.h"

namespace prosector {
namespace {

void add_solvers(const std::string& model, std::vector<Rung>& rungs) {
  const SoftDesc scene;
  if (model != scene.model) return;
  for (const std::string& solver : solver_names())
    if (solver != scene.solver) rungs.push_back({model, scene.integrator, solver});
}

void add_quadratic(const std::string& model, std::vector<Rung>& rungs) {
  const bool law =
      std::any_of(laws().begin(), laws().end(), [&](const LawRow& row) { return row.name == model; });
  if (!law) return;
  for (const IntegratorRow& integrator : integrators())
    rungs.push_back({model, integrator.name, SoftDesc{}.solver, "tet10"});
}

/// What a scene in need of speed may ask for: a solve that stops early as a rule.
void add_budgeted(const std::string& model, std::vector<Rung>& rungs) {
  if (model != "fem_corotational" && model != "fem_neo_hookean" && model != "fem_fibers") return;
  Rung rung{model, "implicit_euler", "cg"};
  rung.newton_iterations = 1;
  rung.solver_iterations = 20;
  rungs.push_back(rung);
}

}  // namespace

std::vector<Rung> stability_rungs(const std::string& only_model) {
  std::vector<Rung> rungs;
  for (const ModelRow& model : models()) {
    if (!only_model.empty() && model.name != only_model) continue;
    for (const std::string& integrator : integrators_for(model))
      rungs.push_back({model.name, integrator, SoftDesc{}.solver});
    add_solvers(model.name, rungs);
    add_quadratic(model.name, rungs);
    add_budgeted(model.name, rungs);
  }
  return rungs;
}

std::string row_name(const Rung& rung) {
  if (rung.newton_iterations == SoftDesc{}.newton_iterations &&
      rung.solver_iterations == SoftDesc{}.solver_iterations)
    return rung.name();
  return fmt::format("{}, {} × {}", rung.name(), rung.newton_iterations, rung.solver_iterations);
}

}  // namespace prosector
