#pragma once
// Cutting a closed surface by a plane into two closed ones: how a bone breaks.

#include "common/mesh.h"

namespace prosector {

struct CutSurface {
  TriangleMesh above, below;  // on the side that the normal points to, and the rest; either may be empty
};

/// Cuts `mesh`, which is closed: every edge of a triangle is some other's, the other way round. Several
/// closed surfaces may be in one mesh, beside, over or inside each other. Vertices at one place count as one.
/// Those on the plane are taken to be a nanometre above it. Both results are closed and fill what the mesh
/// fills. Throws InputError for a surface that isn't closed where it is cut.
CutSurface cut_surface(const TriangleMesh& mesh, const Vec3& point, const Vec3& normal);

}  // namespace prosector
