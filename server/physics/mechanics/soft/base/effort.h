#pragma once
// Effort per tick of a body, and its reduction when accuracy is stepped down.

#include <algorithm>

#include "common/scene/scene.h"

namespace prosector::soft {

struct Effort {
  int newton_iterations, solver_iterations;
  double solver_tolerance;
  int substeps;  // for position-based bodies
};

/// Returns the solver effort per tick after `steps_down` reductions of accuracy. Each reduction halves the
/// scene's numbers of Newton iterations, solver iterations and substeps, and multiplies the solver tolerance
/// by four. The limits are 1 Newton iteration, 8 solver iterations, a tolerance of 0.1 and 4 substeps, or the
/// scene's value if that is less effort. Explicit bodies cannot be reduced: stability determines their
/// substeps.
inline Effort effort_of(const SoftConfiguration& configuration, int steps_down) {
  const auto halved = [&](int n, int least) { return std::max(std::min(n, least), n >> steps_down); };
  const double loosened = configuration.solver_tolerance * static_cast<double>(1 << (2 * steps_down));
  return {halved(configuration.newton_iterations, 1), halved(configuration.solver_iterations, 8),
          std::max(configuration.solver_tolerance, std::min(0.1, loosened)),
          halved(configuration.substeps, 4)};
}

}  // namespace prosector::soft
