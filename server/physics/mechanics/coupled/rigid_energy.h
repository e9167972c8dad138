#pragma once
// Energy of a rigid body over a tick of h s as a function of its twist ξ, see island.h. It has two terms:
// inertia, ½(ξ − ξ̃)ᵀ(M/h²)(ξ − ξ̃), and the pull of a hand's virtual coupling.

#include "server/physics/mechanics/coupled/island.h"

namespace prosector {

/// Returns the inertia term, J.
double inertia_energy(const RigidMember& body, const Vec6& twist, double h);
/// Adds inertia and pull to the sum, J, one by one: the order of additions is part of the result.
void add_energy(const RigidMember& body, const Vec6& twist, double h, double& sum);
/// Writes the gradient by ξ: N, then N·m.
void set_gradient(const RigidMember& body, const Vec6& twist, double h, Eigen::Ref<Vec6> out);
/// Returns the Hessian, with an upper bound for the pull.
Mat6 hessian_of(const RigidMember& body, const Vec6& twist, double h);

}  // namespace prosector
