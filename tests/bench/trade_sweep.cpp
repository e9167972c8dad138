#include "tests/bench/trade_sweep.h"

#include <span>

#include "server/physics/mechanics/soft/integrators/time_integrator.h"
#include "server/physics/mechanics/soft/rungs.h"

namespace prosector {
namespace {

constexpr double frame = 1. / 60;
/// Factorising more quadratic elements takes a quarter of a minute, every Newton iteration.
constexpr std::size_t most_quadratic_for_direct = 2000;

struct Effort {
  int newton, solver;
  double tolerance;
};
/// From one glance to converged; the scene's default among them.
const Effort efforts[] = {
    {1, 20, 1e-2},
    {SoftDesc{}.newton_iterations, SoftDesc{}.solver_iterations, SoftDesc{}.solver_tolerance},
    {5, 300, 1e-3},
    {20, 2000, 1e-6}};

std::vector<unsigned> resolutions(const TradeCase& which, bool quick) {
  std::vector<unsigned> cells = which.cells;
  if (quick) cells.resize(std::min<std::size_t>(cells.size(), 2));
  return cells;
}

/// Where time matters steps are varied; where only the settled shape does, a frame's step will do.
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

/// Whose elements may be quadratic; springs know no others than linear ones.
bool is_law(const ModelRow& model) {
  return model.name.rfind("fem_", 0) == 0;
}

/// Where a ball presses, the solvers that real time affords.
std::vector<std::string> solvers_for(const TradeCase& which) {
  if (which.pressed) return {"cg", "multigrid"};
  return solver_names();
}

/// Rungs of one model and element at every effort.
std::vector<Rung> efforts_of(const TradeCase& which, const ModelRow& model, const std::string& element) {
  const std::string integrator = SoftDesc{}.integrator;
  std::vector<Rung> out;
  if (model.position_based) {
    for (const int substeps : {5, SoftDesc{}.substeps, 50, 200}) {
      out.push_back({model.name, integrator, SoftDesc{}.solver, element});
      out.back().substeps = substeps;
    }
    return out;
  }
  for (const std::string& solver : solvers_for(which))
    for (const Effort& effort : efforts) {
      // An exact solve has no effort of its own: only the Newton iterations count.
      if (solver == "direct" && effort.tolerance != SoftDesc{}.solver_tolerance) continue;
      out.push_back(with({model.name, integrator, solver, element}, effort));
    }
  return out;
}

/// Every integrator on linear elements, and on quadratic ones those that explicit methods' short steps do not
/// make dearer than they are worth.
std::vector<Rung> ways_through_time(const ModelRow& model) {
  const std::string solver = SoftDesc{}.solver;
  std::vector<Rung> out;
  for (const std::string& integrator : integrators_for(model))
    out.push_back({model.name, integrator, solver});
  if (!is_law(model)) return out;
  for (const IntegratorRow& row : integrators()) out.push_back({model.name, row.name, solver, "tet10"});
  return out;
}

}  // namespace

std::vector<Trial> trials(const TradeCase& which, bool quick) {
  std::vector<Trial> all;
  const std::string first_integrator = SoftDesc{}.integrator;
  for (const ModelRow& model : models()) {
    if (!model.tets) continue;
    for (const std::string& element : element_names()) {
      if (!is_law(model) && element != SoftDesc{}.element) continue;
      for (const unsigned cells : resolutions(which, quick))
        for (const Rung& rung : efforts_of(which, model, element)) {
          const bool dear = rung.solver == "direct" && element == "tet10" &&
                            which.piece(cells).mesh.tets.size() > most_quadratic_for_direct;
          if (!dear) all.push_back({rung, cells, frame});
        }
    }
    for (const Rung& rung : ways_through_time(model))
      for (const double dt : steps(which, quick)) {
        if (rung.integrator == first_integrator && dt == frame) continue;  // above
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
