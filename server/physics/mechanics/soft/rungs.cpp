#include "server/physics/mechanics/soft/rungs.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "common/error.h"
#include "server/physics/mechanics/soft/base/find_row.h"
#include "server/physics/mechanics/soft/integrators/explicit_integrators.h"
#include "server/physics/mechanics/soft/integrators/time_integrator.h"
#include "server/physics/mechanics/soft/laws/constitutive_law.h"

namespace prosector::soft {

MeshKind mesh_kind(const Anatomy& anatomy) {
  if (!anatomy.segments.empty()) return MeshKind::rope;
  return anatomy.quads.empty() && anatomy.triangles.empty() ? MeshKind::tets : MeshKind::sheet;
}

const std::vector<ModelRow>& models() {
  static const std::vector<ModelRow> rows = [] {
    std::vector<ModelRow> out = {
        {"mass_spring",
         "springs along the edges of tetrahedra; also for sheets and ropes, with resistance to bending", true,
         true, false},
        {"xpbd", "position-based dynamics with small substeps; the fastest model", true, true, true}};
    for (const LawRow& law : laws()) out.push_back({law.name, law.help, true, false, false});
    return out;
  }();
  return rows;
}

std::vector<std::string> integrators_for(const ModelRow& model) {
  if (model.position_based) return {"implicit_euler"};
  std::vector<std::string> names;
  for (const IntegratorRow& row : integrators()) names.emplace_back(row.name);
  for (const ExplicitRow& row : explicit_integrators()) names.emplace_back(row.name);
  return names;
}

namespace {

void check_relaxation(const SoftDesc& desc) {
  if (desc.configuration.model.rfind("fem_", 0) != 0)
    throw InputError(fmt::format(
        "has relaxation, which model \"{}\" does not support; allowed: models whose name starts with fem_",
        desc.configuration.model));
  std::vector<std::string> implicit;
  for (const IntegratorRow& row : integrators()) implicit.emplace_back(row.name);
  if (std::find(implicit.begin(), implicit.end(), desc.configuration.integrator) == implicit.end())
    throw InputError(fmt::format("integrator is \"{}\"; allowed with relaxation: {}",
                                 desc.configuration.integrator, fmt::join(implicit, ", ")));
  double shares = 0;
  for (const RelaxationDesc& term : desc.material.relaxation) {
    if (!(term.share > 0 && term.time > 0) || !std::isfinite(term.time))
      throw InputError(fmt::format("a relaxation term has share {} and time {} s; allowed: both positive",
                                   term.share, term.time));
    shares += term.share;
  }
  if (!(shares < 1))
    throw InputError(
        fmt::format("the shares of all relaxation terms add up to {}; allowed: a sum below 1", shares));
}

}  // namespace

std::string in_words(const SoftDesc& desc) {
  if (find_row(models(), "model", desc.configuration.model).position_based)
    return fmt::format("{}, {} substeps", desc.configuration.model, desc.configuration.substeps);
  const bool is_explicit =
      std::any_of(explicit_integrators().begin(), explicit_integrators().end(),
                  [&](const ExplicitRow& row) { return row.name == desc.configuration.integrator; });
  if (is_explicit)
    return fmt::format("{}, {}, {}", desc.configuration.model, desc.configuration.element,
                       desc.configuration.integrator);
  const std::string effort =
      desc.configuration.solver == "direct"
          ? fmt::format("{} Newton", desc.configuration.newton_iterations)
          : fmt::format("{} x {} to {:.0e}", desc.configuration.newton_iterations,
                        desc.configuration.solver_iterations, desc.configuration.solver_tolerance);
  return fmt::format("{}, {}, {}, {} {}", desc.configuration.model, desc.configuration.element,
                     desc.configuration.integrator, desc.configuration.solver, effort);
}

void check_rung(const SoftDesc& desc, const Anatomy& anatomy) {
  const ModelRow& model = find_row(models(), "model", desc.configuration.model);
  const MeshKind kind = mesh_kind(anatomy);
  if (!(kind == MeshKind::tets ? model.tets : model.fabric)) {
    std::vector<std::string> fit;
    for (const ModelRow& row : models())
      if (kind == MeshKind::tets ? row.tets : row.fabric) fit.push_back(row.name);
    throw InputError(fmt::format("model is \"{}\", which needs tetrahedra; allowed for a {}: {}",
                                 desc.configuration.model, kind == MeshKind::sheet ? "sheet" : "rope",
                                 fmt::join(fit, ", ")));
  }
  if (desc.configuration.is_quadratic() && (model.fabric || kind != MeshKind::tets))
    throw InputError(
        fmt::format("element is \"tet10\"; allowed with model \"{}\": only tet4", desc.configuration.model));
  if (!desc.material.regions.empty() && kind != MeshKind::tets)
    throw InputError(
        "the sheet or rope has regions, which need tetrahedra; remove them: it can have only one material");
  if (desc.material.fiber_stiffness > 0 && desc.configuration.model != "fem_fibers")
    throw InputError(
        fmt::format("fiber_stiffness is {} Pa; allowed with model \"{}\": 0 (only fem_fibers has fibres)",
                    desc.material.fiber_stiffness, desc.configuration.model));
  const auto allowed = integrators_for(model);
  if (std::find(allowed.begin(), allowed.end(), desc.configuration.integrator) == allowed.end())
    throw InputError(fmt::format("integrator is \"{}\"; allowed with model \"{}\": {}",
                                 desc.configuration.integrator, desc.configuration.model,
                                 fmt::join(allowed, ", ")));
  if (!desc.material.relaxation.empty()) check_relaxation(desc);
}

}  // namespace prosector::soft
