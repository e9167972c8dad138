#pragma once
// Tables of rungs that a test makes up.

#include "server/calibration/bend_reference.h"
#include "server/calibration/choose_rung.h"

namespace prosector::test {

/// A made-up machine: tet10 is nine times as right as tet4 at the same mesh and six times as dear an element,
/// errors fall with the square of the cells, work that is left undone costs some error. xpbd is cheap and 20
/// % off at any mesh.
inline RungFigures made_up(const RungTrial& trial) {
  const Rung& rung = trial.rung;
  const double n = trial.cells;
  RungFigures out;
  out.elements = 6 * n * (n / 4) * (n / 4);
  const bool quadratic = rung.element == "tet10";
  const double error = rung.model == "xpbd" ? 0.2 : (quadratic ? 2.0 : 18.0) / (n * n);
  const double right =
      continuum_sag(rung.model, trial.poisson_ratio).value_or(tissue_sag(trial.poisson_ratio));
  out.settled_sag = right * (1 - error);
  const bool thorough = rung.newton_iterations > 1;
  out.drift = rung.model == "xpbd" ? 0 : thorough ? 1e-4 : 0.01;
  out.iterations = thorough ? 30 : 10;
  const double each =
      rung.model == "xpbd" ? 5e-5 * rung.substeps : (quadratic ? 6e-3 : 1e-3) * (thorough ? 3 : 1);
  out.ms = each * out.elements * (rung.solver == "multigrid" ? 1.1 : 1);
  return out;
}

inline RungTable made_up_table(const SoftDesc& desc) {
  RungTable table;
  for (const RungTrial& trial : trials_for(desc)) table.add(trial, made_up(trial));
  return table;
}

}  // namespace prosector::test
