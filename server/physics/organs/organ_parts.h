#pragma once
// What an organ is put together from.

#include "server/physics/cutting/skin.h"
#include "server/physics/organs/node_transfer.h"
#include "server/physics/soft/base/mesh_edit.h"
#include "server/physics/topology.h"

namespace prosector {

/// Returns the anatomy with the vertices alone; what hangs on the middle of an edge hangs on its ends.
Anatomy without_edge_nodes(const Anatomy& anatomy);

PieceMesh piece_mesh(const TetComplex& complex, std::span<const TetId> tets);

/// What a cut, or what takes one back, changed in a piece.
struct PieceEdit {
  std::size_t body = 0;
  std::vector<NodeId> nodes;  // new ones
  std::vector<TetId> tets;    // mesh.tets' ids
  MeshEdit mesh;
  std::vector<std::uint32_t> touched;  // of a sheet, by index: corners of cells and of triangles of others
                                       // that came or went; ascending
};

/// Returns the edit of a piece that nothing came off. `touched`: tetrahedra that may have changed: children
/// of its tetrahedra, or corners that were parted.
PieceEdit edit_of(const TetComplex& complex, const PieceMesh& piece, std::vector<TetId> touched);
void apply(const TetComplex& complex, const PieceEdit& edit, PieceMesh& piece);
/// Returns the edit between two pieces of one organ, whatever it was that happened between. What is at the
/// same place with the same corners is what it was.
PieceEdit edit_between(const PieceMesh& before, const PieceMesh& now);
/// Tells whether following the edit takes less than making all anew, which comes to the same.
bool is_worth_following(const PieceEdit& edit);

/// The surface of a piece, hanging on its nodes.
struct PieceSurface {
  TriangleMesh surface;
  SparseMap embedding;
  Numbering numbering;
};

/// What a vertex of the skin hangs on, and where it is at rest (m). `index_of`: a node's index in the piece.
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

/// Returns the surface of the piece's skin. Vertices and triangles are numbered by their slots, from
/// `first_vertex` and `first_triangle` on.
PieceSurface skinned(const TetComplex& complex, const Skin& skin, const PieceMesh& piece,
                     std::uint32_t first_vertex, std::uint32_t first_triangle);

/// Returns one tetrahedron, without a surface: what is left to be solved of a piece that was joined to
/// another.
Anatomy remnant(const Anatomy& whole);

}  // namespace prosector
