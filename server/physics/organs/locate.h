#pragma once
// Which tetrahedra points of the room are in.

#include <optional>
#include <span>
#include <vector>

#include "common/mesh.h"

namespace prosector {

/// Of a mesh whose nodes are at `x` (3n, m; more nodes than the tetrahedra's corners may follow), for each
/// point the corners of the first tetrahedron that contains it, its faces included, with the point's
/// barycentric weights; empty outside. Turned-over tetrahedra contain nothing. One pass over the mesh,
/// however many points.
std::vector<std::optional<SparseMap::Row>> locate(const TetMesh& mesh, const VecX& x,
                                                  std::span<const Vec3> points);

}  // namespace prosector
