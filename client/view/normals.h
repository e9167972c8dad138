#pragma once
// Normals for rendering.

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
  std::vector<std::uint32_t> source;  // by vertex: its vertex in the given mesh
};

inline constexpr double crease_angle = 0.7;  // rad between the normals of two triangles that share an edge

/// Makes normals smooth across edges with a crease angle below `angle`, and sharp across the others. The
/// triangles need not be wound consistently.
CreasedMesh split_creases(const TriangleMesh& mesh, double angle = crease_angle);

}  // namespace prosector
