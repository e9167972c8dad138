#pragma once
// A rung of the soft ladder as it is varied to be measured: a row of each of the physics' own tables and an
// effort.

#include <string>
#include <vector>

#include "common/scene/scene.h"
#include "server/calibration/specimen.h"

namespace prosector {

/// One way of solving: model, element, integrator, solver. Settings beyond the tables' defaults are the scene
/// file's: SoftDesc's initialisers.
struct Rung {
  std::string model, integrator, solver;
  std::string element = SoftDesc{}.element;
  int newton_iterations = SoftDesc{}.newton_iterations;
  int solver_iterations = SoftDesc{}.solver_iterations;
  double solver_tolerance = SoftDesc{}.solver_tolerance;
  int substeps = SoftDesc{}.substeps;  // position-based models

  bool operator==(const Rung&) const = default;
  /// Puts the rung into a body's description.
  void apply_to(SoftDesc& desc) const;
  /// Returns how much is spent on a step, for people.
  std::string effort() const;
  std::string name() const;  // model, element, integrator, solver
  bool is_position_based() const;
};

std::vector<std::string> element_names();
std::vector<std::string> solver_names();

/// Makes a specimen of that piece. Throws InputError when the rung refuses it.
std::unique_ptr<Specimen> make_specimen(const Rung& rung, const TestPiece& piece);

}  // namespace prosector
