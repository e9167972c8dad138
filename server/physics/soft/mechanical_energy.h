#pragma once
// Energies of a soft body in motion, J. What it stores is IncrementalPotential::elastic_energy().

#include "server/physics/soft/soft_body.h"

namespace prosector {

/// Returns Σ ½m‖v‖². `mass`: n, kg; `v`: 3n, m/s.
double kinetic_energy(const VecX& mass, const VecX& v);
/// Returns what gravity (m/s²) gave on the way from one shape to another: 0 where it doesn't act.
double fall_energy(const SoftBody& body, const VecX& from, const VecX& to, const Vec3& gravity);

}  // namespace prosector
