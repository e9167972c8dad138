#pragma once
// Structured tetrahedral mesh of a box, used for comparisons on beams and blocks.

#include "common/mesh.h"

namespace prosector {

/// Makes a tetrahedral mesh of the box [0, size] (m) in nx × ny × nz cells. Each cell is split into 6
/// tetrahedra, one per permutation of the axes (Kuhn 1960). The mesh is conforming, its tetrahedra are
/// congruent up to reflection. Node order: node(i, j, k) = i + (nx + 1)(j + (ny + 1)k). Throws InputError if
/// a count is 0, a size isn't positive, or there would be more than 2^24 nodes.
TetMesh kuhn_box(const Vec3& size, std::uint32_t nx, std::uint32_t ny, std::uint32_t nz);

}  // namespace prosector
