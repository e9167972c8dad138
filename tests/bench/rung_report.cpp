#include "tests/bench/rung_report.h"

namespace prosector {

ReportRow settings(const Rung& rung) {
  return {{"model", rung.model},
          {"element", rung.element},
          {"integrator", rung.integrator},
          {"solver", rung.solver},
          {"newton_iterations", rung.newton_iterations},
          {"solver_iterations", rung.solver_iterations},
          {"solver_tolerance", rung.solver_tolerance},
          {"effort", rung.effort()}};
}

}  // namespace prosector
