#pragma once
// How much is spent on a tick of a body, and how that shrinks when it steps down.

#include <algorithm>

#include "common/scene/scene.h"

namespace prosector {

struct Effort {
  int newton_iterations, solver_iterations;
  double solver_tolerance;
  int substeps;  // position-based bodies
};

/// Returns what the description says, halved at each of `steps_down` (the tolerance grows fourfold at each).
/// It stays at what still makes a step: 1 Newton iteration of 8, a tolerance of 0.1, 4 substeps, or what the
/// description has where that is less. Explicit bodies have nothing to give: their substeps are what
/// stability takes.
inline Effort effort_of(const SoftDesc& desc, int steps_down) {
  const auto halved = [&](int n, int least) { return std::max(std::min(n, least), n >> steps_down); };
  const double loosened = desc.solver_tolerance * static_cast<double>(1 << (2 * steps_down));
  return {halved(desc.newton_iterations, 1), halved(desc.solver_iterations, 8),
          std::max(desc.solver_tolerance, std::min(0.1, loosened)), halved(desc.substeps, 4)};
}

}  // namespace prosector
