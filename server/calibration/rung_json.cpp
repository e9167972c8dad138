#include "server/calibration/rung_json.h"

namespace prosector {

nlohmann::ordered_json rung_to_json(const Rung& rung) {
  return {{"model", rung.model},
          {"element", rung.element},
          {"integrator", rung.integrator},
          {"solver", rung.solver},
          {"newton_iterations", rung.newton_iterations},
          {"solver_iterations", rung.solver_iterations},
          {"solver_tolerance", rung.solver_tolerance},
          {"substeps", rung.substeps}};
}

Rung rung_from_json(const nlohmann::ordered_json& row) {
  Rung rung;
  row.at("model").get_to(rung.model);
  row.at("element").get_to(rung.element);
  row.at("integrator").get_to(rung.integrator);
  row.at("solver").get_to(rung.solver);
  row.at("newton_iterations").get_to(rung.newton_iterations);
  row.at("solver_iterations").get_to(rung.solver_iterations);
  row.at("solver_tolerance").get_to(rung.solver_tolerance);
  row.at("substeps").get_to(rung.substeps);
  return rung;
}

}  // namespace prosector
