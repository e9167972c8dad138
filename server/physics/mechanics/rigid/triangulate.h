#pragma once
// Triangulation of planar polygons with holes.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/math.h"

namespace prosector::rigid {

using Vec2 = Eigen::Vector2d;

/// Triangulates polygons with holes by ear clipping; a hole is first joined to the surrounding loop by a
/// bridge (Eberly 2002). Each of `loops` lists indices into `points`: counter-clockwise around a polygon's
/// inside, clockwise around a hole. Loops may touch, but must not cross themselves or each other. Returns
/// counter-clockwise triangles as indices into `points`. They use only the loops' points, and the loops are
/// the boundary of the triangulated area.
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Vec2> points,
                                                      const std::vector<std::vector<std::uint32_t>>& loops);

}  // namespace prosector::rigid
