#pragma once
// Normals of surfaces that are drawn smooth.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/math.h"

namespace prosector {

/// Computes unit normals at vertices: the mean of the triangles around, weighted by area. A vertex whose
/// triangles have no area gets +y, never NaN. `normals` is resized; nothing is allocated when its size
/// already fits.
void smooth_normals(std::span<const Eigen::Vector3f> positions,
                    std::span<const std::array<std::uint32_t, 3>> triangles,
                    std::vector<Eigen::Vector3f>& normals);

}  // namespace prosector
