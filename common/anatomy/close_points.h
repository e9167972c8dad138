#pragma once
// Points that lie so close together that they are meant as one.

#include <cstdint>
#include <span>
#include <vector>

#include "common/math.h"

namespace prosector {

/// How close points of a mesh file may be that are meant as one, as a fraction of the mesh's extent: a few
/// roundings in single precision.
inline constexpr double rounding_of_extent = 1e-6;

/// Returns, for each point, the number of the point that stands for it: the first one within `tolerance` of
/// it that stands for itself, else its own. Points are finite; O(n) where few lie together.
std::vector<std::uint32_t> close_points(std::span<const Vec3> points, double tolerance);

/// Returns the largest side of the points' box; 0 for none.
double extent_of(std::span<const Vec3> points);

}  // namespace prosector
