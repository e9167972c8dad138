#include "tests/bench/stability_rungs.h"

#include <fmt/format.h>

#include <algorithm>

#include "server/physics/mechanics/soft/integrators/time_integrator.h"
#include "server/physics/mechanics/soft/laws/constitutive_law.h"
#include "server/physics/mechanics/soft/rungs.h"
#include "tests/bench/rung_choices.h"

namespace prosector {
namespace {

void add_solvers(const std::string& model, std::vector<StabilityRung>& rungs) {
  const SoftDesc scene;
  if (model != scene.configuration.model) return;
  for (const std::string& solver : solver_names())
    if (solver != scene.configuration.solver)
      rungs.push_back({{model, scene.configuration.integrator, solver}});
}

void add_quadratic(const std::string& model, std::vector<StabilityRung>& rungs) {
  const bool law = std::any_of(soft::laws().begin(), soft::laws().end(),
                               [&](const soft::LawRow& row) { return row.name == model; });
  if (!law) return;
  for (const soft::IntegratorRow& integrator : soft::integrators())
    rungs.push_back(
        {{model, integrator.name, SoftDesc{}.configuration.solver, "tet10"}, PieceMesh::few_tets});
}

/// Adds a configuration whose solver usually stops at its iteration limit, as fast scenes use it.
void add_budgeted(const std::string& model, std::vector<StabilityRung>& rungs) {
  if (model != "fem_corotational" && model != "fem_neo_hookean" && model != "fem_fibers") return;
  Rung rung{model, "implicit_euler", "cg"};
  rung.newton_iterations = 1;
  rung.solver_iterations = 20;
  rungs.push_back({rung});
}

void add_fabrics(const soft::ModelRow& model, std::vector<StabilityRung>& rungs) {
  if (!model.fabric) return;
  for (const PieceMesh mesh : {PieceMesh::sheet, PieceMesh::rope})
    for (const std::string& integrator : soft::integrators_for(model))
      rungs.push_back({{model.name, integrator, SoftDesc{}.configuration.solver}, mesh});
}

}  // namespace

std::vector<StabilityRung> stability_rungs(const std::string& only_model) {
  std::vector<StabilityRung> rungs;
  for (const soft::ModelRow& model : soft::models()) {
    if (!only_model.empty() && model.name != only_model) continue;
    for (const std::string& integrator : soft::integrators_for(model))
      rungs.push_back({{model.name, integrator, SoftDesc{}.configuration.solver}});
    add_solvers(model.name, rungs);
    add_quadratic(model.name, rungs);
    add_budgeted(model.name, rungs);
    add_fabrics(model, rungs);
  }
  return rungs;
}

bool is_fabric(PieceMesh mesh) {
  return mesh == PieceMesh::sheet || mesh == PieceMesh::rope;
}

const char* mesh_name(PieceMesh mesh) {
  return mesh == PieceMesh::sheet ? "sheet" : mesh == PieceMesh::rope ? "rope" : "tets";
}

std::string row_name(const StabilityRung& row) {
  const Rung& rung = row.rung;
  std::string name = rung.name();
  if (is_fabric(row.mesh))  // fabrics have no element
    name.replace(name.find(rung.element), rung.element.size(), mesh_name(row.mesh));
  if (rung.newton_iterations == SoftDesc{}.configuration.newton_iterations &&
      rung.solver_iterations == SoftDesc{}.configuration.solver_iterations)
    return name;
  return fmt::format("{}, {} × {}", name, rung.newton_iterations, rung.solver_iterations);
}

}  // namespace prosector
