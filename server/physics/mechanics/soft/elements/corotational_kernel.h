#pragma once
// Arithmetic of the corotational law on batches of linear tetrahedra, with the widest vectors that the CPU
// supports. Only +, −, ·, / and √ are used, and elements do not depend on each other, so every vector width
// gives bitwise equal results.
//
// With r_a = R·b_a and the twists of fem_corotational.cpp the element's stiffness is
//   K_ab = V·(2μ (r_a·r_b) I + λ r_a r_bᵀ + ½ [r_a]ₓ C [r_b]ₓᵀ),   C = Σ_k c_k u_k u_kᵀ,  u_k = R v_k.
// This takes a tenth of the work of contracting a 9×9 tangent.

#include <span>

#include "server/physics/mechanics/soft/elements/corotated_elements.h"
#include "server/physics/mechanics/soft/elements/tet4.h"
#include "server/physics/mechanics/soft/simd/element_lanes.h"

namespace prosector {

/// Computes F = edges·gradientsᵀ. `edges`: present edge vectors from node 0, m.
void lane_gradients(const LaneRest& rest, const LaneMatrix& edges, LaneMatrix& F);
/// Computes strain.R from strain.F; equals polar() up to rounding.
void lane_rotations(LaneStrain& strain);

/// Computes V·W, J.
void lane_corotational_energy(const LaneRest& rest, const LaneStrain& strain, double* energy);
/// Computes V·P·b_a, N, of the first forces.size() elements.
void lane_corotational_forces(const LaneRest& rest, const LaneStrain& strain,
                              std::span<Tet4Elements::Forces> forces);
/// Computes θ = R:F − 3 of the first theta.size() elements.
void lane_corotational_dilatations(const LaneStrain& strain, std::span<double> theta);
/// Computes V·R·b_a, m²: V·∂θ/∂x_a of every objective law at F = R, and of the corotational law at any F.
void lane_turned_gradients(const LaneRest& rest, const LaneMatrix& R, std::span<Tet4Elements::Forces> G);
/// Computes the projected tangent's blocks of the first K.size() elements, N/m.
void lane_corotational_stiffness(const LaneRest& rest, const LaneStrain& strain,
                                 std::span<Tet4Elements::Stiffness> K);
/// Computes the linear elastic stiffness rotated by R (warped stiffness, Müller & Gross 2004): the tangent of
/// every objective law at F = R.
void lane_warped_stiffness(const LaneRest& rest, const LaneMatrix& R, std::span<Tet4Elements::Stiffness> K);

/// Computes the first twists.size() elements in the form of corotated_elements.h, see
/// ElasticModel::linearise.
void lane_turned_elements(const LaneRest& rest, const LaneStrain& strain, double share,
                          std::span<CorotatedVector> gradients, std::span<Twist> twists);

}  // namespace prosector
