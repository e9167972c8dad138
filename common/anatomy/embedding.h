#pragma once
// Ties a surface to the tetrahedra that carry it.

#include "common/mesh.h"

namespace prosector {

/// Largest weight of a vertex outside all tetrahedra; beyond it the vertex is drawn in towards its nearest
/// tetrahedron, so that no small motion of a node is magnified much.
inline constexpr double max_embedding_weight = 6;

/// Barycentric weights of each surface vertex in the tetrahedron that contains it, or, outside, the nearest
/// one's, extrapolated. Each surface vertex then stands exactly at W.row(i)·nodes.
struct Embedding {
  Anatomy anatomy;
  std::size_t outside = 0;   // surface vertices in no tetrahedron
  std::size_t drawn_in = 0;  // of them, so far out that the weight limit moved them
  double farthest = 0;       // m: how far it moved one at most
};
Embedding embed(TetMesh tets, TriangleMesh surface);

/// Sets surface.positions = W·tets.positions.
void apply_embedding(Anatomy& anatomy);

}  // namespace prosector
