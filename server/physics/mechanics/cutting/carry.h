#pragma once
// Transfer of node data (positions, velocities) through a topology change.

#include <vector>

#include "server/physics/mechanics/cutting/tet_complex.h"

namespace prosector {

/// Transfers values, by node id, through a topology change; `values` grows. A new node on an edge gets the
/// interpolated value, copies get the value of their node. With masses lumped from the tetrahedra, linear
/// momentum and the centre of mass are conserved.
void carry(const TopologyOp& op, std::vector<Vec3>& values);

}  // namespace prosector
