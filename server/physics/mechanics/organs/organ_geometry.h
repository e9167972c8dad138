#pragma once
// Geometry of an organ's pieces, and its changes by cuts.

#include <optional>

#include "server/physics/base/surface_edit.h"
#include "server/physics/base/topology.h"
#include "server/physics/mechanics/organs/organ.h"

namespace prosector {

/// Returns a piece's tetrahedra with their skin as the surface and cut faces as inner, or a piece of a sheet.
/// While no cut is in force this is the compiled mesh. A piece that was joined to another is one tetrahedron
/// or cell without a surface.
Anatomy anatomy_of(const Organ& organ, const OrganPiece& piece, Numbering& numbering);
/// Returns the surface only.
PieceSurface surface_of(const Organ& organ, const OrganPiece& piece);

/// Returns the mesh edit of the changes since the last regroup() or follow(), if they are cuts in one piece
/// that severed nothing; otherwise none.
std::optional<PieceEdit> cut_in_one_piece(const Organ& organ);
/// Returns the surface edit for that mesh edit, before follow(). The piece must have been cut before.
/// `surface` and `numbering`: those before the edit.
SurfaceEdit surface_edit(const Organ& organ, const PieceEdit& edit, const TriangleMesh& surface,
                         const Numbering& numbering);

/// Returns the edit from the body's mesh by anatomy_of() before that regroup() to its current mesh. Returns
/// none if the body was not or is not a piece.
std::optional<PieceEdit> edit_since(const Organ& organ, const Regrouped& then, const OrganPiece& piece);
/// Returns the edit from a tetrahedral body's previous surface, with its numbering, to the current one.
/// Returns none if one of them is the compiled surface.
std::optional<SurfaceEdit> surface_edit_since(const Organ& organ, const Regrouped& then,
                                              const OrganPiece& piece, const TriangleMesh& surface,
                                              const Numbering& numbering);

}  // namespace prosector
