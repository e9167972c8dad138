#pragma once
// Which tetrahedron a point of the room is in.

#include <optional>

#include "common/mesh.h"

namespace prosector {

/// Of a mesh whose nodes are at `x` (3n, m; more nodes than the tetrahedra's corners may follow): the corners
/// of the first tetrahedron that contains the point, its faces included, with the point's barycentric
/// weights. Empty outside; turned-over tetrahedra contain nothing.
std::optional<SparseMap::Row> locate(const TetMesh& mesh, const VecX& x, const Vec3& point);

}  // namespace prosector
