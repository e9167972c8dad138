#pragma once
// Which tetrahedra still hang together.

#include <vector>

#include "server/physics/cutting/tet_complex.h"

namespace prosector {

/// A body's pieces, joined through faces: their tetrahedra, ascending; the piece with the lowest id first.
std::vector<std::vector<TetId>> pieces(const TetComplex& complex);

}  // namespace prosector
