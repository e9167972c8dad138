#pragma once
// Detection of points that coincide within a tolerance.

#include <cstdint>
#include <span>
#include <vector>

#include "common/math.h"

namespace prosector {

/// Tolerance for coinciding points of a mesh file, as a fraction of the mesh's extent: several
/// single-precision rounding errors.
inline constexpr double rounding_of_extent = 1e-6;

/// Returns the index of each point's representative: the first representative within `tolerance` of the
/// point, else the point itself. Points must be finite. O(n) if few points are close together.
std::vector<std::uint32_t> coincident_points(std::span<const Vec3> points, double tolerance);

/// Returns the largest side of the points' bounding box; 0 without points.
double extent_of(std::span<const Vec3> points);

}  // namespace prosector
