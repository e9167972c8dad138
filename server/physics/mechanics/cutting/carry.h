#pragma once
// Transfer of node data (positions, velocities) through a topology change.

#include <vector>

#include "server/physics/mechanics/cutting/tet_complex.h"

namespace prosector::cutting {

/// Updates node data (`values`, such as positions or velocities, by node id) for a topology change; `values`
/// grows. A new node on an edge gets the interpolated value of the edge's ends, and copies of a node get the
/// value of that node. With masses lumped from the tetrahedra, linear momentum and the centre of mass are
/// conserved.
void carry(const TopologyOp& op, std::vector<Vec3>& values);

}  // namespace prosector::cutting
