#pragma once
// What a scene can ask for, at its default budget: the rows of the stability map.

#include "server/calibration/rung.h"
#include "tests/bench/extreme.h"

namespace prosector {

struct StabilityRung {
  Rung rung;
  PieceMesh mesh = PieceMesh::tets;
};

/// Every model under every integrator that goes with it, linear tetrahedra; the default model with every
/// solver; every law on quadratic tetrahedra under every implicit integrator; laws that fit
/// large strain by implicit Euler with a budget of 20 iterations of conjugate gradients a tick; models for
/// fabrics on a sheet and a rope under every integrator. Empty `only_model`: all models.
std::vector<StabilityRung> stability_rungs(const std::string& only_model);
/// Its name, with the budget where that is not a scene's default.
std::string row_name(const StabilityRung& rung);
bool is_fabric(PieceMesh mesh);
const char* mesh_name(PieceMesh mesh);

}  // namespace prosector
