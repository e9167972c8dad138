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

namespace prosector::soft {

/// Computes the deformation gradients F = edges·gradientsᵀ of a batch of linear tetrahedra. `edges`: columns
/// x_a − x_0, m, a = 1 … 3, at current positions; the gradients are those of the shape functions, in `rest`.
void lane_gradients(const LaneRest& rest, const LaneMatrix& edges, LaneMatrix& F);
/// Computes the rotation of each element of the batch, strain.R, from its deformation gradient, strain.F, by
/// polar decomposition. Equals polar() up to rounding.
void lane_rotations(LaneStrain& strain);

/// Computes the strain energy V·W(F), J, of each element of the batch under the corotational law.
void lane_corotational_energy(const LaneRest& rest, const LaneStrain& strain, double* energy);
/// Computes the gradients V·P·b_a (N) of the energy with respect to the four node positions of the batch's
/// first forces.size() elements. P is the first Piola stress of the corotational law, and b_a is the gradient
/// of shape function a.
void lane_corotational_forces(const LaneRest& rest, const LaneStrain& strain,
                              std::span<Tet4Elements::Forces> forces);
/// Computes the corotational law's measure of volume change, θ = R:F − 3, of the first theta.size() elements
/// of the batch.
void lane_corotational_dilatations(const LaneStrain& strain, std::span<double> theta);
/// Computes V·R·b_a, m², for the four nodes of each element in a batch; b_a is the gradient of shape function
/// a. This is V·∂θ/∂x_a, the derivative of the volume change θ, for the corotational law, and at F = R for
/// every objective law.
void lane_turned_gradients(const LaneRest& rest, const LaneMatrix& R, std::span<Tet4Elements::Forces> G);
/// Computes the stiffness blocks (N/m) of the first K.size() elements of the batch: the tangent of the
/// corotational law, projected to have no negative eigenvalue.
void lane_corotational_stiffness(const LaneRest& rest, const LaneStrain& strain,
                                 std::span<Tet4Elements::Stiffness> K);
/// Computes the warped stiffness (N/m) of the first K.size() elements of the batch: the linear elastic
/// stiffness, rotated by R (Müller & Gross 2004). At F = R it is the tangent of every objective law.
void lane_warped_stiffness(const LaneRest& rest, const LaneMatrix& R, std::span<Tet4Elements::Stiffness> K);

/// Computes the first twists.size() elements of the batch as rotated elements: four rotated gradients and one
/// twist matrix T each (corotated_elements.h). `share` is defined at ElasticModel::linearise().
void lane_turned_elements(const LaneRest& rest, const LaneStrain& strain, double share,
                          std::span<CorotatedVector> gradients, std::span<Twist> twists);

}  // namespace prosector::soft
