#pragma once
// Building blocks of an organ's geometry.

#include "server/physics/base/topology.h"
#include "server/physics/mechanics/cutting/skin.h"
#include "server/physics/mechanics/organs/node_transfer.h"
#include "server/physics/mechanics/soft/base/mesh_edit.h"

namespace prosector::organs {

/// Returns a copy of `anatomy` without the edge nodes of quadratic tetrahedra. In the surface's embedding,
/// the weight of an edge node is distributed equally to the two ends of its edge.
Anatomy without_edge_nodes(const Anatomy& anatomy);

PieceMesh piece_mesh(const cutting::TetComplex& complex, std::span<const cutting::TetId> tets);

/// Changes of the mesh of one piece of an organ by a cut or an undo: new nodes and changed tetrahedra with
/// their ids, and the mesh edit by index.
struct PieceEdit {
  std::size_t body = 0;
  std::vector<cutting::NodeId> nodes;  // new nodes
  std::vector<cutting::TetId> tets;    // ids of mesh.tets
  soft::MeshEdit mesh;
  // For sheets: indices of the corners of changed cells, and of the changed triangles of other cells;
  // ascending.
  std::vector<std::uint32_t> touched;
};

/// Returns the changes of a piece's mesh by cuts that severed nothing from it. `complex`: the organ's mesh
/// after the cuts; `piece`: the piece before them. `touched`: ids of the tetrahedra that may have changed.
/// Each of them is a tetrahedron of the piece, whose corners may have been duplicated, or a child of one.
PieceEdit edit_of(const cutting::TetComplex& complex, const PieceMesh& piece,
                  std::vector<cutting::TetId> touched);
void apply(const cutting::TetComplex& complex, const PieceEdit& edit, PieceMesh& piece);
/// Returns the changes between two states of the mesh of one piece of an organ, for any cuts and undos
/// between them. A tetrahedron counts as unchanged if its sort key (`places`) and its corners are the same.
PieceEdit edit_between(const PieceMesh& before, const PieceMesh& now);
/// Returns whether it is cheaper to update data incrementally by `edit` than to rebuild them, which gives the
/// same result. That holds if at most a quarter of the piece's tetrahedra changed.
bool is_worth_following(const PieceEdit& edit);

/// Surface triangles of a piece of an organ, the embedding of their vertices in the piece's nodes, and the
/// permanent numbers of nodes, vertices and triangles.
struct PieceSurface {
  TriangleMesh surface;
  SparseMap embedding;
  Numbering numbering;
};

/// Surface vertex of a cut body, embedded in the nodes of one piece: indices and weights of up to four nodes,
/// and its rest position (m).
struct HungVertex {
  SparseMap::Row row;
  Vec3 rest = Vec3::Zero();
};
template <class F>
HungVertex hang(const cutting::TetComplex& complex, const cutting::Skin::Vertex& vertex, const F& index_of) {
  HungVertex out;
  for (std::size_t k = 0; k < 4; ++k) {
    if (vertex.weight[k] == 0) continue;
    out.row.node[k] = index_of(vertex.node[k]);
    out.row.weight[k] = vertex.weight[k];
    out.rest += vertex.weight[k] * complex.rest(vertex.node[k]);
  }
  return out;
}

/// Returns the surface of one piece of a cut organ: the triangles of the organ's `skin` whose tetrahedra are
/// in the piece. A vertex gets the permanent number `first_vertex` plus its slot in the skin, and a triangle
/// `first_triangle` plus its slot.
PieceSurface skinned(const cutting::TetComplex& complex, const cutting::Skin& skin, const PieceMesh& piece,
                     std::uint32_t first_vertex, std::uint32_t first_triangle);

/// Returns a single tetrahedron, or sheet cell, of the uncut organ `whole`, without a surface. It is the
/// placeholder mesh of a soft body whose piece was joined to another piece by an undo.
Anatomy remnant(const Anatomy& whole);

}  // namespace prosector::organs
