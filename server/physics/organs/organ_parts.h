#pragma once
// What an organ is put together from.

#include "server/physics/cutting/skin.h"
#include "server/physics/organs/node_transfer.h"
#include "server/physics/topology.h"

namespace prosector {

/// The vertices alone; what hangs on the middle of an edge hangs on its ends.
Anatomy without_edge_nodes(const Anatomy& anatomy);

PieceMesh piece_mesh(const TetComplex& complex, std::vector<TetId> tets);

/// Every tetrahedron that these changes, just made, took away, brought or joined otherwise; ascending.
std::vector<TetId> touched_by(const TetComplex& complex, const std::vector<TopologyOp>& ops);

/// A piece with its skin's triangles as its surface. Vertices and triangles are numbered by their slots, from
/// `first_vertex` and `first_triangle` on.
Anatomy skinned(const TetComplex& complex, const Skin& skin, const PieceMesh& piece,
                std::uint32_t first_vertex, std::uint32_t first_triangle, Numbering& numbering);

/// One tetrahedron, without a surface: what is left to be solved of a piece that was joined to another.
Anatomy remnant(const Anatomy& whole);

}  // namespace prosector
