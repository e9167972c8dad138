#pragma once
// Triangulation of planar polygons with holes.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/math.h"

namespace prosector {

using Vec2 = Eigen::Vector2d;

/// Triangulates polygons by ear clipping; a hole is first joined to the surrounding loop by a bridge (Eberly
/// 2002). `loops`: indices into `points`, counter-clockwise around the inside, clockwise around holes. Loops
/// may touch, but don't cross themselves or each other. Triangles are counter-clockwise, use only the loops'
/// indices, and their common boundary is the loops.
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Vec2> points,
                                                      const std::vector<std::vector<std::uint32_t>>& loops);

}  // namespace prosector
