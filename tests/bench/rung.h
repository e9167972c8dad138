#pragma once
// A rung of the soft ladder as the benches vary it: every row of the physics' own tables in turn.

#include <string>
#include <vector>

#include "common/scene/scene.h"
#include "tests/bench/report.h"
#include "tests/bench/specimen.h"

namespace prosector {

/// Settings beyond the tables' defaults are the scene file's: SoftDesc's initialisers.
struct Rung {
  std::string model, integrator, solver;
  std::string element = SoftDesc{}.element;
  int newton_iterations = SoftDesc{}.newton_iterations;
  int solver_iterations = SoftDesc{}.solver_iterations;
  double solver_tolerance = SoftDesc{}.solver_tolerance;

  /// How much is spent on a step, for people.
  std::string effort() const;
  std::string name() const;  // model, element, integrator, solver
};

std::vector<std::string> model_names();
std::vector<std::string> element_names();
std::vector<std::string> integrator_names();
std::vector<std::string> solver_names();

/// The rung as the columns of a report.
ReportRow settings(const Rung& rung);

/// A specimen of that piece. Throws InputError when the rung refuses it.
std::unique_ptr<Specimen> make_specimen(const Rung& rung, const TestPiece& piece);

}  // namespace prosector
