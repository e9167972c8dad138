#pragma once
// Simplification of a triangle surface by collapsing short edges, with unchanged topology.

#include <functional>

#include "common/mesh.h"

namespace prosector {

/// Simplifies the surface by collapsing edges until they are about `edge` metres long (mean within some 30 %
/// for surfaces that were finer). A collapse must keep the surface a manifold (link condition), rotate no
/// triangle by more than 60°, and make no edge longer than 1.6·edge. Borders of open surfaces are unchanged.
/// `project`, if given, moves a new vertex back onto the original surface.
TriangleMesh simplify(const TriangleMesh& mesh, double edge,
                      const std::function<Vec3(const Vec3&)>& project = {});

/// Removes triangles that contain a vertex twice, and vertices that no triangle uses.
void drop_unused(TriangleMesh& mesh);

}  // namespace prosector
