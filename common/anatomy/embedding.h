#pragma once
// Embedding of a surface in a tetrahedral mesh.

#include "common/mesh.h"

namespace prosector {

/// Largest barycentric weight of a surface vertex outside all tetrahedra. A vertex with a larger weight is
/// moved towards its nearest tetrahedron, so that small motions of a node are not amplified.
inline constexpr double max_embedding_weight = 6;

/// A surface embedded in a tetrahedral mesh: each surface vertex has barycentric weights in the tetrahedron
/// that contains it. Outside the mesh, those of the nearest tetrahedron are extrapolated. Vertex i is then at
/// W.row(i)·nodes.
struct Embedding {
  Anatomy anatomy;
  std::size_t outside = 0;   // number of surface vertices outside all tetrahedra
  std::size_t drawn_in = 0;  // number of these that the weight limit moved
  double farthest = 0;       // m: largest distance by which it moved one
};
Embedding embed(TetMesh tets, TriangleMesh surface);

/// Moves the vertices of the anatomy's surface to the positions that follow from its nodes: sets
/// surface.positions = W·tets.positions, with the embedding W.
void apply_embedding(Anatomy& anatomy);

}  // namespace prosector
