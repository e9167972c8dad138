#pragma once
// Connected pieces of tetrahedra.

#include <vector>

#include "server/physics/mechanics/cutting/tet_complex.h"

namespace prosector {

/// Returns a body's pieces, which are connected through faces: their tetrahedra, ascending; the piece with
/// the lowest id first.
std::vector<std::vector<TetId>> pieces(const TetComplex& complex);

/// Returns whether these tetrahedra, which were connected before, or their descendants are still connected.
/// The search visits no more tetrahedra than needed.
bool hang_together(const TetComplex& complex, std::span<const TetId> tets);

}  // namespace prosector
