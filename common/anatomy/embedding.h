#pragma once
// Embedding of a surface in a tetrahedral mesh.

#include "common/mesh.h"

namespace prosector {

/// Largest weight of a vertex outside all tetrahedra. A vertex with a larger weight is moved towards its
/// nearest tetrahedron, so that small motions of a node are not amplified.
inline constexpr double max_embedding_weight = 6;

/// Barycentric weights of each surface vertex in the tetrahedron that contains it. Outside the mesh, those of
/// the nearest tetrahedron are extrapolated. Vertex i is then at W.row(i)·nodes.
struct Embedding {
  Anatomy anatomy;
  std::size_t outside = 0;   // number of surface vertices outside all tetrahedra
  std::size_t drawn_in = 0;  // number of these that the weight limit moved
  double farthest = 0;       // m: largest distance by which it moved one
};
Embedding embed(TetMesh tets, TriangleMesh surface);

/// Sets surface.positions = W·tets.positions.
void apply_embedding(Anatomy& anatomy);

}  // namespace prosector
