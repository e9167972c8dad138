#pragma once
// Cuts a closed surface along a plane into two closed surfaces: the fracture of a bone.

#include "common/mesh.h"

namespace prosector::rigid {

struct CutSurface {
  // The parts on the side that the normal points to, and on the other side; either may be empty.
  TriangleMesh above, below;
};

/// Cuts `mesh` along the plane through `point` with `normal`, and returns the parts above and below the plane
/// as closed surfaces. Together they fill the volume of the mesh.
///
/// The mesh must be closed: each directed edge of a triangle is paired with the opposite edge of another
/// triangle. It may contain several closed surfaces, next to, across or inside each other. Vertices with
/// equal positions count as one. Vertices within a nanometre of the plane are treated as a nanometre above
/// it. Throws InputError for a surface that is not closed along the cut.
CutSurface cut_surface(const TriangleMesh& mesh, const Vec3& point, const Vec3& normal);

}  // namespace prosector::rigid
