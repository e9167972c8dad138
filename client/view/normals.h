#pragma once
// Normals for drawing.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh.h"

namespace prosector {

/// Computes unit normals at vertices: the mean of the triangles around, weighted by area. A vertex whose
/// triangles have no area gets +y, never NaN. `normals` is resized; nothing is allocated when its size
/// already fits.
void smooth_normals(std::span<const Eigen::Vector3f> positions,
                    std::span<const std::array<std::uint32_t, 3>> triangles,
                    std::vector<Eigen::Vector3f>& normals);

/// A surface whose vertices are split along its sharp edges.
struct CreasedMesh {
  std::vector<Eigen::Vector3f> positions, normals;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> source;  // vertex of the given mesh behind each of these
};

inline constexpr double crease_angle = 0.7;  // rad between the normals of two triangles that share an edge

/// Makes normals smooth within edges below `angle`, sharp at those above. Wound consistently or not, any
/// surface will do.
CreasedMesh split_creases(const TriangleMesh& mesh, double angle = crease_angle);

}  // namespace prosector
