#pragma once
// Detection of points that coincide within a tolerance.

#include <cstdint>
#include <span>
#include <vector>

#include "common/math.h"

namespace prosector {

/// Distance, as a fraction of a mesh's extent, up to which points of a mesh file count as one point. It
/// covers several single-precision rounding errors.
inline constexpr double rounding_of_extent = 1e-6;

/// Returns, for each point, the index of the point that represents it: the first representative within
/// `tolerance` of the point, or else the point itself. Points must be finite. Takes O(n) time if few points
/// are close together.
std::vector<std::uint32_t> coincident_points(std::span<const Vec3> points, double tolerance);

/// Returns the longest side of the points' axis-aligned bounding box, in the points' unit; 0 without points.
double extent_of(std::span<const Vec3> points);

}  // namespace prosector
