#pragma once
// Building blocks of an organ's geometry.

#include "server/physics/base/topology.h"
#include "server/physics/mechanics/cutting/skin.h"
#include "server/physics/mechanics/organs/node_transfer.h"
#include "server/physics/mechanics/soft/base/mesh_edit.h"

namespace prosector {

/// Returns the anatomy with vertices only. Embedding rows on edge nodes are distributed to the edges' ends.
Anatomy without_edge_nodes(const Anatomy& anatomy);

PieceMesh piece_mesh(const TetComplex& complex, std::span<const TetId> tets);

/// Changes of a piece by a cut or an undo.
struct PieceEdit {
  std::size_t body = 0;
  std::vector<NodeId> nodes;  // new nodes
  std::vector<TetId> tets;    // ids of mesh.tets
  MeshEdit mesh;
  // For sheets: indices of the corners of changed cells, and of the changed triangles of other cells;
  // ascending.
  std::vector<std::uint32_t> touched;
};

/// Returns the edit of a piece from which nothing was severed. `touched`: tetrahedra that may have changed,
/// which are children of its tetrahedra or have parted corners.
PieceEdit edit_of(const TetComplex& complex, const PieceMesh& piece, std::vector<TetId> touched);
void apply(const TetComplex& complex, const PieceEdit& edit, PieceMesh& piece);
/// Returns the edit between two states of a piece, for any changes between them. A tetrahedron with the same
/// place and corners is unchanged.
PieceEdit edit_between(const PieceMesh& before, const PieceMesh& now);
/// Returns whether applying the edit costs less than a rebuild, which gives the same result.
bool is_worth_following(const PieceEdit& edit);

/// The surface of a piece, embedded in its nodes.
struct PieceSurface {
  TriangleMesh surface;
  SparseMap embedding;
  Numbering numbering;
};

/// Embedding of a skin vertex, and its rest position (m). `index_of`: a node's index in the piece.
struct HungVertex {
  SparseMap::Row row;
  Vec3 rest = Vec3::Zero();
};
template <class F>
HungVertex hang(const TetComplex& complex, const Skin::Vertex& vertex, const F& index_of) {
  HungVertex out;
  for (std::size_t k = 0; k < 4; ++k) {
    if (vertex.weight[k] == 0) continue;
    out.row.node[k] = index_of(vertex.node[k]);
    out.row.weight[k] = vertex.weight[k];
    out.rest += vertex.weight[k] * complex.rest(vertex.node[k]);
  }
  return out;
}

/// Returns the surface of the piece's skin. Vertices and triangles are numbered by their slots, starting from
/// `first_vertex` and `first_triangle`.
PieceSurface skinned(const TetComplex& complex, const Skin& skin, const PieceMesh& piece,
                     std::uint32_t first_vertex, std::uint32_t first_triangle);

/// Returns one tetrahedron without a surface: the placeholder mesh of a piece that was joined to another.
Anatomy remnant(const Anatomy& whole);

}  // namespace prosector
