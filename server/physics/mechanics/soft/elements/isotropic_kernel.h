#pragma once
// Arithmetic of isotropic laws on batches of elements, with the widest vectors that the CPU supports. Each
// law is evaluated as by its ConstitutiveLaw, up to rounding.

#include <span>

#include "server/physics/mechanics/soft/elements/point_tangents.h"
#include "server/physics/mechanics/soft/elements/tet4.h"
#include "server/physics/mechanics/soft/simd/element_lanes.h"

namespace prosector::soft {

/// Laws of this kernel, named as in laws().
enum class IsotropicLaw { fem_linear, fem_stvk, fem_neo_hookean, fem_neo_hookean_polynomial };

/// Computes the strain energy V·W(F), J, of each element of the batch.
void lane_energy(IsotropicLaw law, const LaneRest& rest, const LaneStrain& strain, double* energy);
/// Computes the gradients V·P·b_a (N) of the energy with respect to the four node positions of the batch's
/// first forces.size() elements. P is the first Piola stress, which includes that of the external pressure,
/// and b_a is the gradient of shape function a.
void lane_forces(IsotropicLaw law, const LaneRest& rest, const LaneStrain& strain,
                 std::span<Tet4Elements::Forces> forces);
/// Computes the law's measure of volume change θ(F) of the first theta.size() elements of the batch.
void lane_dilatations(IsotropicLaw law, const LaneStrain& strain, std::span<double> theta);
/// Computes V·∂θ/∂x_a, m², for the four nodes a of the batch's first G.size() elements.
void lane_dilatation_forces(IsotropicLaw law, const LaneRest& rest, const LaneStrain& strain,
                            std::span<Tet4Elements::Forces> G);
/// Computes the tangents at the points of a batch. Each is `share` times the law's tangent, projected to have
/// no negative eigenvalue. To it is added 1 − `share` times the linear elastic stiffness in the rotated
/// frame. Requires strain.R, except for fem_linear.
void lane_point_tangents(IsotropicLaw law, const LaneRest& rest, const LaneStrain& strain, double share,
                         PointTangents& out);

}  // namespace prosector::soft
