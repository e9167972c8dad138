#pragma once
// Normals for drawing.

#include <array>
#include <cstdint>
#include <vector>

#include "common/mesh.h"
#include "common/smooth_normals.h"

namespace prosector {

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
