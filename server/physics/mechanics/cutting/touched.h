#pragma once
// Tetrahedra changed by a cut, to update dependent data locally.

#include <vector>

#include "server/physics/mechanics/cutting/tet_complex.h"

namespace prosector {

/// Returns all tetrahedra that these operations, just applied, removed, added or connected differently;
/// ascending.
std::vector<TetId> touched_by(const TetComplex& complex, const std::vector<TopologyOp>& ops);

}  // namespace prosector
