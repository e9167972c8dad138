#pragma once
// Sheets and ropes: geometry whose nodes lie on a surface or a line, for springs and position-based bodies.

#include "common/mesh.h"

namespace prosector {

/// A rectangle of size.x × size.z in the x–z plane around the origin, size.y thick, in cells of about `cell`
/// metres. Its drawn and touched surface is the sheet's middle, seen from both sides: each node is two
/// vertices.
Anatomy make_sheet(const Vec3& size, double cell);

/// A line along x around the origin, size.x long, size.y in diameter, in pieces of about `cell` metres. Its
/// surface is its axis, one vertex per node and no triangle: what draws it lays a tube around.
Anatomy make_rope(const Vec3& size, double cell);

}  // namespace prosector
