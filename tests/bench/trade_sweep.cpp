#include "tests/bench/trade_sweep.h"

#include <span>

#include "server/physics/mechanics/soft/integrators/time_integrator.h"
#include "server/physics/mechanics/soft/rungs.h"
#include "tests/bench/rung_choices.h"

namespace prosector {
namespace {

constexpr double frame = 1. / 60;
/// Quadratic elements up to which the direct solver is run: factorising more takes 15 s per Newton iteration.
constexpr std::size_t most_quadratic_for_direct = 2000;

struct Effort {
  int newton, solver;
  double tolerance;
};
/// Efforts from a single iteration to convergence, including the scene's default.
const Effort efforts[] = {
    {1, 20, 1e-2},
    {SoftDesc{}.configuration.newton_iterations, SoftDesc{}.configuration.solver_iterations,
     SoftDesc{}.configuration.solver_tolerance},
    {5, 300, 1e-3},
    {20, 2000, 1e-6}};

std::vector<unsigned> resolutions(const TradeCase& which, bool quick) {
  std::vector<unsigned> cells = which.cells;
  if (quick) cells.resize(std::min<std::size_t>(cells.size(), 2));
  return cells;
}

/// Returns the time steps: several if the case tests motion, else 1/60 s.
std::vector<double> steps(const TradeCase& which, bool quick) {
  if (!which.moving) return {frame};
  if (quick) return {frame, frame / 4};
  return {frame, frame / 2, frame / 4, frame / 16};
}

Rung with(const Rung& rung, const Effort& effort) {
  Rung out = rung;
  out.newton_iterations = effort.newton;
  out.solver_iterations = effort.solver;
  out.solver_tolerance = effort.tolerance;
  return out;
}

/// Returns whether the model is a constitutive law. Only laws support quadratic elements.
bool is_law(const soft::ModelRow& model) {
  return model.name.rfind("fem_", 0) == 0;
}

/// Returns the solvers of a case; with a ball, only those fast enough for real time.
std::vector<std::string> solvers_for(const TradeCase& which) {
  if (which.pressed) return {"cg", "multigrid"};
  return solver_names();
}

/// Returns the configurations of a model and element, with every solver at every effort.
std::vector<Rung> efforts_of(const TradeCase& which, const soft::ModelRow& model,
                             const std::string& element) {
  const std::string integrator = SoftDesc{}.configuration.integrator;
  std::vector<Rung> out;
  if (model.position_based) {
    for (const int substeps : {5, SoftDesc{}.configuration.substeps, 50, 200}) {
      out.push_back({model.name, integrator, SoftDesc{}.configuration.solver, element});
      out.back().substeps = substeps;
    }
    return out;
  }
  for (const std::string& solver : solvers_for(which))
    for (const Effort& effort : efforts) {
      // A direct solve has no iteration count: only the Newton iterations are varied.
      if (solver == "direct" && effort.tolerance != SoftDesc{}.configuration.solver_tolerance) continue;
      out.push_back(with({model.name, integrator, solver, element}, effort));
    }
  return out;
}

/// Returns all integrators on linear elements, and the implicit ones on quadratic elements, where explicit
/// methods need very short steps.
std::vector<Rung> ways_through_time(const soft::ModelRow& model) {
  const std::string solver = SoftDesc{}.configuration.solver;
  std::vector<Rung> out;
  for (const std::string& integrator : soft::integrators_for(model))
    out.push_back({model.name, integrator, solver});
  if (!is_law(model)) return out;
  for (const soft::IntegratorRow& row : soft::integrators())
    out.push_back({model.name, row.name, solver, "tet10"});
  return out;
}

}  // namespace

std::vector<Trial> trials(const TradeCase& which, bool quick) {
  std::vector<Trial> all;
  const std::string first_integrator = SoftDesc{}.configuration.integrator;
  for (const soft::ModelRow& model : soft::models()) {
    if (!model.tets) continue;
    for (const std::string& element : element_names()) {
      if (!is_law(model) && element != SoftDesc{}.configuration.element) continue;
      for (const unsigned cells : resolutions(which, quick))
        for (const Rung& rung : efforts_of(which, model, element)) {
          const bool dear = rung.solver == "direct" && element == "tet10" &&
                            which.piece(cells).mesh.tets.size() > most_quadratic_for_direct;
          if (!dear) all.push_back({rung, cells, frame});
        }
    }
    for (const Rung& rung : ways_through_time(model))
      for (const double dt : steps(which, quick)) {
        if (rung.integrator == first_integrator && dt == frame) continue;  // run above
        all.push_back({with(rung, efforts[2]), which.cells[0], dt});
      }
  }
  return all;
}

std::vector<BulletTrial> bullet_trials(const TradeCase& which, bool quick) {
  std::vector<BulletTrial> all;
  if (which.pressed) return all;
  for (const BulletRung& rung : bullet_rungs()) {
    for (const unsigned cells : resolutions(which, quick)) {
      for (const double dt : steps(which, quick)) all.push_back({rung, cells, dt});
    }
  }
  return all;
}

}  // namespace prosector
