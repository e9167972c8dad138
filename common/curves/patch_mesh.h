#pragma once
// Triangulation of surface patches.

#include "common/curves/patch.h"
#include "common/mesh.h"

namespace prosector {

/// Grid lines over a surface patch, given by their parameters u and v: increasing from 0 to 1.
struct PatchGrid {
  std::vector<double> u, v;
};

/// Maximum number of grid points with which a surface patch is triangulated.
inline constexpr std::size_t max_grid_points = 250 * 1000;
/// Returns a grid over the patch that is fine enough for the patch to be within `tolerance` (m) of the
/// triangles of the grid's cells. The distance is sampled at the quarter points and middle of the cells'
/// sides and diagonals. Throws InputError if more than max_grid_points points are needed.
PatchGrid refine_grid(const Patch& patch, double tolerance);

/// Builds a closed surface around the patch: two faces at half of `thickness` (m) along the normal on each
/// side, and a rim. Triangles are within `tolerance` (m) of it. Throws InputError if the patch has no area,
/// or if too many grid points are needed.
TriangleMesh slab_mesh(const Patch& patch, double thickness, double tolerance);

}  // namespace prosector
