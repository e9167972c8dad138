#pragma once
// Geometry of the pieces of a cut sheet.

#include "common/scene/scene.h"
#include "server/physics/base/topology.h"
#include "server/physics/mechanics/organs/organ_parts.h"

namespace prosector::organs {

/// Returns the mesh and surface of one piece of a cut sheet: intact quadrilateral cells as cells, the rest of
/// the other cells as triangles. Node masses are stored as volumes (mass over density). The surface has two
/// sides. `numbering` receives permanent numbers: compiled nodes, vertices and triangles have their indices
/// in the uncut sheet `whole`, and new ones have higher numbers.
Anatomy sheet_piece(const cutting::TetComplex& complex, const PieceMesh& piece, const Anatomy& whole,
                    Numbering& numbering);

/// Returns the ascending node indices for PieceEdit::touched of a piece of a cut sheet. They are `edited`,
/// the nodes of its MeshEdit, and the corners of all compiled cells that contain a triangle in `touched`
/// (ids). `nodes`: the piece's node ids, ascending.
std::vector<std::uint32_t> touched_corners(const cutting::TetComplex& complex,
                                           std::span<const cutting::NodeId> nodes,
                                           std::vector<std::uint32_t> edited, const Anatomy& whole,
                                           std::span<const cutting::TetId> touched);

/// Returns a single quadrilateral cell of the uncut sheet `whole`, without a surface. It is the placeholder
/// mesh of a soft body whose piece was joined to another piece by an undo.
Anatomy sheet_remnant(const Anatomy& whole);

/// Returns for each node of an uncut sheet 1 if an attachment with positive stiffness holds it, that is, if
/// it lies within the attachment's radius; otherwise 0.
std::vector<std::uint8_t> held_nodes(const std::vector<AttachDesc>& attach, const Anatomy& sheet);

}  // namespace prosector::organs
