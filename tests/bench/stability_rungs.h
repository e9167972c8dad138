#pragma once
// Configurations that the stability map tests: those that a scene can request, with default budgets.

#include "server/calibration/rung.h"
#include "tests/bench/extreme.h"

namespace prosector {

struct StabilityRung {
  Rung rung;
  PieceMesh mesh = PieceMesh::tets;
};

/// Returns the tested configurations: every model with every compatible integrator on linear tetrahedra; the
/// default model with every solver; every law on quadratic tetrahedra with every implicit integrator; laws
/// for large strain with implicit Euler and 20 conjugate-gradient iterations per tick; fabric models on a
/// sheet and a rope with every integrator. Empty `only_model`: all models.
std::vector<StabilityRung> stability_rungs(const std::string& only_model);
/// Returns the configuration's name, with its iteration budget if that is not a scene's default.
std::string row_name(const StabilityRung& rung);
bool is_fabric(PieceMesh mesh);
const char* mesh_name(PieceMesh mesh);

}  // namespace prosector
