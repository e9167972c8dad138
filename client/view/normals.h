#pragma once
// Normals for rendering.

#include <array>
#include <cstdint>
#include <vector>

#include "common/mesh.h"
#include "common/smooth_normals.h"

namespace prosector {

/// Surface mesh with normals, whose vertices are duplicated along its sharp edges so that each side has a
/// normal.
struct CreasedMesh {
  std::vector<Eigen::Vector3f> positions, normals;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> source;  // by vertex: its vertex in the given mesh
};

inline constexpr double crease_angle = 0.7;  // rad between the normals of two triangles that share an edge

/// Returns the mesh with a normal at each vertex. Normals are smooth across edges where two triangles'
/// normals differ by less than `angle`, rad; at sharper edges the vertices are duplicated. The triangles need
/// not be wound consistently.
CreasedMesh split_creases(const TriangleMesh& mesh, double angle = crease_angle);

}  // namespace prosector
