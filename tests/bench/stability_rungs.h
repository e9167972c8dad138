#pragma once
// What a scene can ask for, at its default budget: the rows of the stability map.

#include "server/calibration/rung.h"

namespace prosector {

/// Every model under every integrator that goes with it, linear tetrahedra; the default model with every
/// solver; every law on quadratic tetrahedra under every implicit integrator; laws that fit
/// large strain by implicit Euler with a budget of 20 iterations of conjugate gradients a tick. Empty
/// `only_model`: all models.
std::vector<Rung> stability_rungs(const std::string& only_model);
/// Its name, with the budget where that is not a scene's default.
std::string row_name(const Rung& rung);

}  // namespace prosector
