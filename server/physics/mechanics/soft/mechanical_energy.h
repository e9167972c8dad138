#pragma once
// Energies of a moving soft body, J. For its stored energy, see IncrementalPotential::elastic_energy().

#include "server/physics/mechanics/soft/base/weight.h"

namespace prosector {

/// Returns Σ ½m‖v‖². `mass`: n, kg; `v`: 3n, m/s.
double kinetic_energy(const VecX& mass, const VecX& v);
/// Returns the work of the body's weight between two shapes, J. `mass`: n, kg.
double fall_energy(const VecX& mass, const VecX& from, const VecX& to, const Weight& weight);

}  // namespace prosector
