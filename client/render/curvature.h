#pragma once
// Curvature of a surface: its hollows and ridges. Private to client/render.

#include <span>
#include <vector>

#include "common/mesh.h"

namespace prosector {

/// Returns the mean curvature at each point, times 4 mm, from −1 (ridges) over 0 (flat) to 1 (hollows).
/// Averages it over the neighbours' neighbours. Triangles must be counter-clockwise from outside.
std::vector<float> curvature_of(std::span<const Eigen::Vector3f> points,
                                std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace prosector
