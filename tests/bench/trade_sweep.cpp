#include "tests/bench/trade_sweep.h"

#include <cstring>
#include <span>

namespace prosector {
namespace {

constexpr double frame = 1. / 60;

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
  const bool is_dynamic = std::strcmp(which.name, "swing") == 0 || std::strcmp(which.name, "free") == 0;
  if (!is_dynamic) return {frame};
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

}  // namespace

std::vector<Trial> trials(const TradeCase& which, bool quick) {
  std::vector<Trial> all;
  const std::vector<std::string> integrators = integrator_names(), solvers = solver_names();
  const std::string first_integrator = SoftDesc{}.integrator, first_solver = SoftDesc{}.solver;
  for (const std::string& model : model_names()) {
    for (const std::string& element : element_names()) {
      for (const unsigned cells : resolutions(which, quick)) {
        for (const std::string& solver : solvers) {
          const Rung rung{model, first_integrator, solver, element};
          for (const Effort& effort : efforts) {
            // An exact solve has no effort of its own: only the Newton iterations count.
            if (solver == "direct" && effort.tolerance != SoftDesc{}.solver_tolerance) continue;
            all.push_back({with(rung, effort), cells, frame});
          }
        }
      }
    }
    for (const std::string& integrator : integrators) {
      for (const double dt : steps(which, quick)) {
        if (integrator == first_integrator && dt == frame) continue;  // above
        all.push_back({with({model, integrator, first_solver}, efforts[2]), which.cells[0], dt});
      }
    }
  }
  return all;
}

std::vector<BulletTrial> bullet_trials(const TradeCase& which, bool quick) {
  std::vector<BulletTrial> all;
  for (const BulletRung& rung : bullet_rungs()) {
    for (const unsigned cells : resolutions(which, quick)) {
      for (const double dt : steps(which, quick)) all.push_back({rung, cells, dt});
    }
  }
  return all;
}

}  // namespace prosector
