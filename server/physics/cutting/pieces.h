#pragma once
// Which tetrahedra still hang together.

#include <vector>

#include "server/physics/cutting/tet_complex.h"

namespace prosector {

/// Returns a body's pieces, joined through faces: their tetrahedra, ascending; the piece with the lowest id
/// first.
std::vector<std::vector<TetId>> pieces(const TetComplex& complex);

/// Tells whether what these tetrahedra, which hung together, are or were split into still hangs together.
/// Looks no farther around them than it takes to tell.
bool hang_together(const TetComplex& complex, std::span<const TetId> tets);

}  // namespace prosector
