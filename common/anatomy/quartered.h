#pragma once
// A surface with a vertex on the middle of each edge.

#include "common/mesh.h"

namespace prosector {

/// Divides each triangle by the middles of its edges into four, which face as it does. The vertices stay
/// first and as they are; an edge that several triangles share gets one middle.
TriangleMesh quartered(TriangleMesh surface);

}  // namespace prosector
