#pragma once
// Reference displacements of a cube and a slab of tissue under their own weight, in the continuum limit. The
// cases cube, slab and hang of `prosector-bench trade` are compared with them.

#include <array>
#include <span>

#include "tests/bench/weighed_body.h"

namespace prosector {

inline constexpr std::size_t weighed_places = 4;

struct WeighedReference {
  const char* name;
  WeighedBody body;
  double poisson_ratio;
  double gravity;  // m/s² along y; the body stands if negative
  Cells coarse;    // cells of the coarsest mesh; finer meshes divide them
  /// Displacements of places_of(), m.
  std::array<Vec3, weighed_places> moved;
  double unsettled;  // uncertainty of `moved`, as a fraction (see error_of)
};

/// Returns the references of the cases cube, slab and hang.
std::span<const WeighedReference> weighed_references();

/// Returns the four evaluated points of the undeformed body, m: centre of the free face, centre of one of its
/// edges, one of its corners, and centre of a side face.
std::array<Vec3, weighed_places> places_of(const WeighedReference& which);

/// Returns the RMS error of the displacements `moved`, relative to the RMS of the reference displacements.
double error_of(const WeighedReference& which, const std::array<Vec3, weighed_places>& moved);

/// Returns the static displacements of the points with quadratic elements. Each cell of the coarsest mesh is
/// divided into `times` cells along each axis. Displacements are averaged over each point and its three
/// mirror images, because the mesh is not symmetric. Throws std::logic_error if the solver does not converge.
std::array<Vec3, weighed_places> moved_at_rest(const WeighedReference& which, std::uint32_t times);

/// Returns the limit extrapolated from three meshes, each with half the cells of the next (Aitken 1926). A
/// component that does not converge monotonically is extrapolated by a third of its last difference.
std::array<Vec3, weighed_places> extrapolated(const std::array<std::array<Vec3, weighed_places>, 3>& by_mesh);

}  // namespace prosector
