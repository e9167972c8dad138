#pragma once
// Tetrahedra changed by a cut, to update dependent data locally.

#include <vector>

#include "server/physics/mechanics/cutting/tet_complex.h"

namespace prosector::cutting {

/// Returns the ids, ascending, of all tetrahedra that these topology changes, which were just applied,
/// removed, added or connected differently. For a sheet, triangles whose nodes changed mass are included.
std::vector<TetId> touched_by(const TetComplex& complex, const std::vector<TopologyOp>& ops);

}  // namespace prosector::cutting
