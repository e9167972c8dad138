#pragma once
// How far a cube and a slab of tissue go under their own weight, in the continuum: what trade's cases of that
// name are judged by.

#include <array>
#include <span>

#include "tests/bench/weighed_body.h"

namespace prosector {

inline constexpr std::size_t weighed_places = 4;

struct WeighedReference {
  const char* name;
  WeighedBody body;
  double poisson_ratio;
  double gravity;  // m/s² along y: below 0 it stands
  Cells coarse;    // of the coarsest mesh; every finer one is this one divided
  /// How far places_of() go, m.
  std::array<Vec3, weighed_places> moved;
  double unsettled;  // fraction: what that may be off, as error_of() has it
};

/// Returns cube, slab and hang.
std::span<const WeighedReference> weighed_references();

/// Returns places of the body at rest, m: the free face's middle, the middle of its edge, its corner, and the
/// middle of a side.
std::array<Vec3, weighed_places> places_of(const WeighedReference& which);

/// Returns the root mean square of the places' errors over that of their displacements.
double error_of(const WeighedReference& which, const std::array<Vec3, weighed_places>& moved);

/// Returns how far the places go in quadratic elements, each of the coarsest mesh's cells cut `times` times
/// along each axis; the mean of each place and its three mirror images, since the mesh isn't symmetric and
/// the body is. Throws std::logic_error where it comes to no rest.
std::array<Vec3, weighed_places> moved_at_rest(const WeighedReference& which, std::uint32_t times);

/// Returns what three meshes lead to, each with half the cells of the next (Aitken 1926). A component that
/// doesn't fall evenly takes a third of its last step more.
std::array<Vec3, weighed_places> extrapolated(const std::array<std::array<Vec3, weighed_places>, 3>& by_mesh);

}  // namespace prosector
