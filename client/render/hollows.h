#pragma once
// Which places of a surface are hollows, and which are ridges. Private to client/render.

#include <span>
#include <vector>

#include "common/mesh.h"

namespace prosector {

/// Returns for each point how hollow the surface is there: its mean curvature times 4 mm, from −1 (ridges)
/// over 0 (flat) to 1 (hollows), averaged over the neighbours' neighbours. Triangles are counter-clockwise
/// from outside.
std::vector<float> hollows_of(std::span<const Eigen::Vector3f> points,
                              std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace prosector
