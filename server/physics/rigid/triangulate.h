#pragma once
// Flat polygons with holes into triangles.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/math.h"

namespace prosector {

using Vec2 = Eigen::Vector2d;

/// Loops of indices into `points`, counter-clockwise around what is inside, clockwise around holes; loops
/// don't cross themselves or each other, but may lie over each other. Triangles are counter-clockwise, use
/// the loops' indices only, and together have the loops for their boundary. By ear clipping, a hole first
/// joined to the loop around it by a bridge (Eberly 2002).
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Vec2> points,
                                                      const std::vector<std::vector<std::uint32_t>>& loops);

}  // namespace prosector
