#pragma once
// Sheets and ropes: meshes whose nodes are on a surface or a line, for mass-spring and position-based bodies.

#include "common/curves/patch.h"
#include "common/mesh.h"

namespace prosector {

/// Makes a flat sheet: a rectangle of size.x × size.z in the x–z plane around the origin, size.y thick, in
/// cells of about `cell` metres. Its drawn and touched surface is the sheet's middle surface, two-sided: each
/// node has two vertices.
Anatomy make_sheet(const Vec3& size, double cell);

/// Makes a sheet over a surface patch, `thickness` m thick, with cells of about `cell` metres along the mean
/// length of the patch's u and v lines. Throws InputError if two nodes coincide, as at a pole.
Anatomy make_sheet(const Patch& patch, double thickness, double cell);

/// Returns the volume (m³) of each node of an uncut sheet: a quarter of the volume of each adjacent cell.
std::vector<double> sheet_node_volumes(const Anatomy& sheet);

/// Makes a rope along x around the origin, size.x long, size.y in diameter, with segments of about `cell`
/// metres. Its surface is its axis, with one vertex per node and no triangles; renderers draw a tube around
/// it.
Anatomy make_rope(const Vec3& size, double cell);

/// Makes a rope along a curve, `diameter` m thick, with segments of about `cell` metres.
Anatomy make_rope(const NurbsCurve& curve, double diameter, double cell);

}  // namespace prosector
