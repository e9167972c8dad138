#include "tests/bench/rung_report.h"

namespace prosector {

ReportRow settings(const Rung& rung) {
  ReportRow row = {{"model", rung.model}, {"element", rung.element}, {"integrator", rung.integrator}};
  if (rung.is_position_based()) {
    row["solver"] = "gauss_seidel";
    row["substeps"] = rung.substeps;
  } else {
    row["solver"] = rung.solver;
    row["newton_iterations"] = rung.newton_iterations;
    row["solver_iterations"] = rung.solver_iterations;
    row["solver_tolerance"] = rung.solver_tolerance;
  }
  row["effort"] = rung.effort();
  return row;
}

}  // namespace prosector
