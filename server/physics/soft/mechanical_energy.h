#pragma once
// Energies of a soft body in motion, J. What it stores is IncrementalPotential::elastic_energy().

#include "server/physics/soft/base/weight.h"

namespace prosector {

/// Returns Σ ½m‖v‖². `mass`: n, kg; `v`: 3n, m/s.
double kinetic_energy(const VecX& mass, const VecX& v);
/// Returns what a body's weight gave on the way from one shape to another. `mass`: n, kg.
double fall_energy(const VecX& mass, const VecX& from, const VecX& to, const Weight& weight);

}  // namespace prosector
