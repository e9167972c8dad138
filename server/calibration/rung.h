#pragma once
// One rung of the ladder of soft models, as calibration varies it: one row of each of the physics' tables,
// and an effort.

#include <string>
#include <vector>

#include "common/scene/scene.h"
#include "server/calibration/specimen.h"

namespace prosector {

/// A configuration to simulate a soft body: model, element, integrator, solver and effort. The effort
/// (iterations, tolerance and substeps) defaults to SoftDesc's values.
struct Rung {
  std::string model, integrator, solver;
  std::string element = SoftDesc{}.configuration.element;
  int newton_iterations = SoftDesc{}.configuration.newton_iterations;
  int solver_iterations = SoftDesc{}.configuration.solver_iterations;
  double solver_tolerance = SoftDesc{}.configuration.solver_tolerance;
  int substeps = SoftDesc{}.configuration.substeps;  // position-based models

  bool operator==(const Rung&) const = default;
  /// Writes this rung (model configuration) into a soft body's description.
  void apply_to(SoftDesc& desc) const;
  /// Returns the effort of a step (iterations, tolerance or substeps) as text.
  std::string effort() const;
  std::string name() const;  // model, element, integrator, solver
  bool is_position_based() const;
};

/// Makes a specimen (a benchmarked body) of that test piece, simulated with the rung (model configuration).
/// Throws InputError if the rung can't model it.
std::unique_ptr<Specimen> make_specimen(const Rung& rung, const TestPiece& piece);

}  // namespace prosector
