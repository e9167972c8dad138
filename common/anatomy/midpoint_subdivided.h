#pragma once
// Midpoint subdivision of a surface.

#include "common/mesh.h"

namespace prosector {

/// Splits each triangle into four at the midpoints of its edges, with the same orientation. Existing vertices
/// keep their indices and positions; triangles that share an edge share its midpoint.
TriangleMesh midpoint_subdivided(TriangleMesh surface);

}  // namespace prosector
