#pragma once
// Geometry of the pieces of a cut sheet.

#include "common/scene/scene.h"
#include "server/physics/base/topology.h"
#include "server/physics/mechanics/organs/organ_parts.h"

namespace prosector {

/// Returns a piece as an anatomy: intact cells as cells, the rest of the other cells as triangles; masses as
/// volumes; a two-sided surface. Vertices and triangles keep their numbers in `whole`; new ones follow.
Anatomy sheet_piece(const TetComplex& complex, const PieceMesh& piece, const Anatomy& whole,
                    Numbering& numbering);

/// Returns PieceEdit::touched of a piece with these nodes, ascending. Joins `edited`, the nodes of its
/// MeshEdit, with the corners of compiled cells that contain the `touched` triangles.
std::vector<std::uint32_t> touched_corners(const TetComplex& complex, std::span<const NodeId> nodes,
                                           std::vector<std::uint32_t> edited, const Anatomy& whole,
                                           std::span<const TetId> touched);

/// Returns one cell without a surface: the placeholder mesh of a piece that was joined to another.
Anatomy sheet_remnant(const Anatomy& whole);

/// Returns by node of an uncut sheet whether an attachment holds it.
std::vector<std::uint8_t> held_nodes(const std::vector<AttachDesc>& attach, const Anatomy& sheet);

}  // namespace prosector
