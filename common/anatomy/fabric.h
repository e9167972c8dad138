#pragma once
// Sheets and ropes: geometry whose nodes lie on a surface or a line, for springs and position-based bodies.

#include "common/curves/patch.h"
#include "common/mesh.h"

namespace prosector {

/// Makes a rectangle of size.x × size.z in the x–z plane around the origin, size.y thick, in cells of about
/// `cell` metres. Its drawn and touched surface is the sheet's middle, seen from both sides: each node is two
/// vertices.
Anatomy make_sheet(const Vec3& size, double cell);

/// Makes a sheet over a patch, `thickness` m thick, in as many cells as its lines along u and v are long on
/// the average. Throws InputError where two of its nodes coincide, as at a pole.
Anatomy make_sheet(const Patch& patch, double thickness, double cell);

/// Returns the volume (m³) of each node of a sheet of whole cells: a quarter of those around it.
std::vector<double> sheet_node_volumes(const Anatomy& sheet);

/// Makes a line along x around the origin, size.x long, size.y in diameter, in pieces of about `cell` metres.
/// Its surface is its axis, one vertex per node and no triangle: what draws it lays a tube around.
Anatomy make_rope(const Vec3& size, double cell);

/// Makes a rope along a curve, `diameter` m thick.
Anatomy make_rope(const NurbsCurve& curve, double diameter, double cell);

}  // namespace prosector
