#pragma once
// Vertex normals for smooth shading.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/math.h"

namespace prosector {

/// Computes unit vertex normals as the area-weighted mean of the adjacent triangles' normals. A vertex whose
/// triangles have no area gets +y, never NaN. Resizes `normals`; allocates nothing if its size already fits.
void smooth_normals(std::span<const Eigen::Vector3f> positions,
                    std::span<const std::array<std::uint32_t, 3>> triangles,
                    std::vector<Eigen::Vector3f>& normals);

}  // namespace prosector
