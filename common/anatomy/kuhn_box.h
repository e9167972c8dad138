#pragma once
// The structured mesh of a box that beams and blocks are compared on.

#include "common/mesh.h"

namespace prosector {

/// Makes the box [0, size] in nx × ny × nz cells, each split into 6 tetrahedra, one per permutation of the
/// axes (Kuhn 1960): conforming, all tetrahedra congruent up to reflection. Nodes are ordered x fastest, then
/// y, z: node(i, j, k) = i + (nx + 1)(j + (ny + 1)k). Throws InputError when a count is 0, a size is not
/// positive, or the mesh would have more than 2^24 nodes.
TetMesh kuhn_box(const Vec3& size, std::uint32_t nx, std::uint32_t ny, std::uint32_t nz);

}  // namespace prosector
