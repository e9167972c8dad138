#pragma once
// What a sheet that was cut is put together from.

#include "common/scene/scene.h"
#include "server/physics/organs/organ_parts.h"
#include "server/physics/topology.h"

namespace prosector {

/// Returns a piece as geometry: whole cells as cells, and what is left of the others; masses as volumes; its
/// surface seen from both sides. Vertices and triangles keep the numbers that they had in `whole`; those that
/// came follow.
Anatomy sheet_piece(const TetComplex& complex, const PieceMesh& piece, const Anatomy& whole,
                    Numbering& numbering);

/// Returns PieceEdit::touched of a piece with these nodes, ascending. These are `edited`, those of its
/// MeshEdit, and the corners of cells of which one of these triangles is a part, or was.
std::vector<std::uint32_t> touched_corners(const TetComplex& complex, std::span<const NodeId> nodes,
                                           std::vector<std::uint32_t> edited, const Anatomy& whole,
                                           std::span<const TetId> touched);

/// Returns one cell, without a surface: what is left to be solved of a piece that was joined to another.
Anatomy sheet_remnant(const Anatomy& whole);

/// Tells by node of an uncut sheet whether the attachments tie it to its place.
std::vector<std::uint8_t> held_nodes(const std::vector<AttachDesc>& attach, const Anatomy& sheet);

}  // namespace prosector
