#pragma once
// Fibres of fem_fibers.cpp on batches of elements, with the widest vectors that the CPU supports.
//
// Let a be the fibre's direction at rest, f = F·a, and t = ⟨|f|² − 1⟩ its stretch excess. Fibres have the
// energy density k/8·t² and the first Piola stress k/2·t f aᵀ. Their tangent is k (f ⊗ a)(f ⊗ a)ᵀ plus
// k/2·t (a aᵀ) ⊗ I.

#include <span>

#include "server/physics/mechanics/soft/elements/point_tangents.h"
#include "server/physics/mechanics/soft/elements/tet4.h"
#include "server/physics/mechanics/soft/simd/element_lanes.h"

namespace prosector::soft {

/// Fibres of a batch: their unit directions a at rest, x, y, z, and stiffness k (Pa; 0: no fibres).
struct alignas(64) LaneFibers {
  double direction[3][elements_per_batch], stiffness[elements_per_batch];
};

/// Adds the energy V·k/8·t², J, of each element's fibres to `energy`.
void lane_add_fiber_energy(const LaneFibers& fibers, const LaneRest& rest, const LaneStrain& strain,
                           double* energy);
/// Adds the forces (N) of the fibres on the four nodes of the batch's first forces.size() elements.
void lane_add_fiber_forces(const LaneFibers& fibers, const LaneRest& rest, const LaneStrain& strain,
                           std::span<Tet4Elements::Forces> forces);
/// Sets the fibres' part of the tangents at the points of the batch. `share` is that of
/// lane_point_tangents(). Requires strain.R.
void lane_fiber_tangents(const LaneFibers& fibers, const LaneRest& rest, const LaneStrain& strain,
                         double share, PointTangents& out);

}  // namespace prosector::soft
