#pragma once
// Takes what nodes have (positions, velocities) through a change of topology.

#include <vector>

#include "server/physics/cutting/tet_complex.h"

namespace prosector {

/// By node id; grows. A new node on an edge has what is there, copies have what their node has: with masses
/// lumped from the tetrahedra, linear momentum and the centre of mass stay.
void carry(const TopologyOp& op, std::vector<Vec3>& values);

/// The way back, before complex.take_back(op), whose masses weigh. Parts that are joined again meet in their
/// centre of mass and keep their momentum; a node that goes gives the edge's ends its momentum.
void carry_back(const TopologyOp& op, const TetComplex& complex, std::vector<Vec3>& positions,
                std::vector<Vec3>& velocities);

}  // namespace prosector
