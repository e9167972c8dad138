#pragma once
// One rung of the ladder of soft models, as calibration varies it: one row of each of the physics' tables,
// and an effort.

#include <string>
#include <vector>

#include "common/scene/scene.h"
#include "server/calibration/specimen.h"

namespace prosector {

/// A configuration to simulate a soft body: model, element, integrator, solver, effort. The effort defaults
/// to SoftDesc's values.
struct Rung {
  std::string model, integrator, solver;
  std::string element = SoftDesc{}.element;
  int newton_iterations = SoftDesc{}.newton_iterations;
  int solver_iterations = SoftDesc{}.solver_iterations;
  double solver_tolerance = SoftDesc{}.solver_tolerance;
  int substeps = SoftDesc{}.substeps;  // position-based models

  bool operator==(const Rung&) const = default;
  /// Writes the rung into a body's description.
  void apply_to(SoftDesc& desc) const;
  /// Returns the effort of a step as text.
  std::string effort() const;
  std::string name() const;  // model, element, integrator, solver
  bool is_position_based() const;
};

std::vector<std::string> element_names();
std::vector<std::string> solver_names();

/// Makes a specimen of that piece. Throws InputError when the rung can't model it.
std::unique_ptr<Specimen> make_specimen(const Rung& rung, const TestPiece& piece);

}  // namespace prosector
