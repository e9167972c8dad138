#pragma once
// Pieces of surfaces as triangles.

#include "common/curves/patch.h"
#include "common/mesh.h"

namespace prosector {

/// Lines of a grid over a patch, rising from 0 to 1.
struct PatchGrid {
  std::vector<double> u, v;
};

/// The most points of a grid.
inline constexpr std::size_t max_grid = 250 * 1000;
/// Makes a grid so fine that between any two neighbouring lines the patch is within `tolerance` (m) of the
/// triangles of the grid's cells. It judges by the cells' quarters and middles. Throws InputError where that
/// takes more than max_grid points.
PatchGrid fit_grid(const Patch& patch, double tolerance);

/// Makes a closed surface around the patch: either face half of `thickness` (m) away from it along its
/// normal, and a rim. Throws InputError where the patch has no area, and as fit_grid() does.
TriangleMesh slab_over(const Patch& patch, double thickness, double tolerance);

}  // namespace prosector
