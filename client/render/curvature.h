#pragma once
// Curvature of a surface: its hollows and ridges. Private to client/render.

#include <span>
#include <vector>

#include "common/mesh.h"

namespace prosector {

/// Returns for each point the surface's mean curvature (1/m) times 0.004 m, limited to −1 (ridges) … 1
/// (hollows); 0 is flat. It is smoothed by averaging over neighbouring points. Triangles must be
/// counter-clockwise from outside.
std::vector<float> curvature_of(std::span<const Eigen::Vector3f> points,
                                std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace prosector
