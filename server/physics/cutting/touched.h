#pragma once
// Where a cut changed the mesh: what follows it looks there, and what depends on it is told by it.

#include <vector>

#include "server/physics/cutting/tet_complex.h"

namespace prosector {

/// Returns every tetrahedron that these changes, just made, took away, brought or joined otherwise;
/// ascending.
std::vector<TetId> touched_by(const TetComplex& complex, const std::vector<TopologyOp>& ops);

}  // namespace prosector
