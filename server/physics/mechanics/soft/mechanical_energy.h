#pragma once
// Energies of a moving soft body, J. For its stored energy, see IncrementalPotential::elastic_energy().

#include "server/physics/mechanics/soft/base/weight.h"

namespace prosector::soft {

/// Returns the kinetic energy Σ ½m‖v‖² of the nodes, J. `mass`: nodal masses (n, kg); `v`: nodal velocities
/// (3n, m/s).
double kinetic_energy(const VecX& mass, const VecX& v);
/// Returns the work of gravity, J, when the nodes move from positions `from` to positions `to` (3n, m).
/// `mass`: nodal masses (n, kg); `weight`: gravitational acceleration of the nodes.
double fall_energy(const VecX& mass, const VecX& from, const VecX& to, const Weight& weight);

}  // namespace prosector::soft
