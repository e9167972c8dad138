#pragma once
// Energy of a rigid body over a tick of h s as a function of its twist ξ, see island.h. It has two terms:
// inertia, ½(ξ − ξ̃)ᵀ(M/h²)(ξ − ξ̃), and the pull of a hand's virtual coupling.

#include "server/physics/mechanics/coupled/island.h"

namespace prosector::coupled {

/// Returns the inertia term of a rigid body's incremental energy, J: ½(ξ − ξ̃)ᵀ(M/h²)(ξ − ξ̃). ξ is `twist`,
/// the displacement over the tick of h s; ξ̃ is the displacement without contacts; M is the mass and inertia
/// matrix.
double inertia_energy(const RigidMember& body, const Vec6& twist, double h);
/// Adds the energy terms (J) of a rigid body over a tick of h s to `sum`: inertia, then the translational and
/// the rotational pull of a hand. They are added one by one because rounding depends on the order.
void add_energy(const RigidMember& body, const Vec6& twist, double h, double& sum);
/// Writes the gradient of a rigid body's incremental energy (inertia and hand's pull) with respect to its
/// twist to `out`: a force (N), then a moment (N·m). `twist`: displacement over the tick of h s.
void set_gradient(const RigidMember& body, const Vec6& twist, double h, Eigen::Ref<Vec6> out);
/// Returns the 6×6 Hessian of a rigid body's incremental energy with respect to its twist, the displacement
/// over the tick of h s. The stiffness of a hand's pull is replaced by its secant stiffness, an upper bound.
Mat6 hessian_of(const RigidMember& body, const Vec6& twist, double h);

}  // namespace prosector::coupled
