#pragma once
// Takes what nodes have (positions, velocities) through a change of topology.

#include <vector>

#include "server/physics/cutting/tet_complex.h"

namespace prosector {

/// Carries values by node id through a change; `values` grows. A new node on an edge has what is there,
/// copies have what their node has. With masses lumped from the tetrahedra, linear momentum and the centre of
/// mass stay.
void carry(const TopologyOp& op, std::vector<Vec3>& values);

}  // namespace prosector
