#pragma once
// Connected pieces of tetrahedra.

#include <vector>

#include "server/physics/mechanics/cutting/tet_complex.h"

namespace prosector::cutting {

/// Returns the connected pieces of a body, each as the ids of its tetrahedra, ascending. Tetrahedra are
/// connected through common faces. Pieces are sorted by their lowest id.
std::vector<std::vector<TetId>> pieces(const TetComplex& complex);

/// Returns whether these tetrahedra, or the tetrahedra into which they were split, are still connected
/// through faces. They must have been connected before. The search stops when the answer is known.
bool hang_together(const TetComplex& complex, std::span<const TetId> tets);

}  // namespace prosector::cutting
