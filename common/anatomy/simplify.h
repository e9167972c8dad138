#pragma once
// Thins a triangle surface by collapsing short edges, keeping its topology.

#include <functional>

#include "common/mesh.h"

namespace prosector {

/// Collapses edges until they are about `edge` metres long (mean within some 30 % for surfaces that were
/// finer). Only collapses that keep the surface a manifold (link condition), turn no triangle by more than
/// 60° and make no edge longer than 1.6 edge; borders of open surfaces stay. `project`, if given, puts a new
/// vertex back onto the surface that the mesh samples.
TriangleMesh simplify(const TriangleMesh& mesh, double edge,
                      const std::function<Vec3(const Vec3&)>& project = {});

/// Drops triangles that name a vertex twice, and vertices that no triangle uses.
void drop_unused(TriangleMesh& mesh);

}  // namespace prosector
