#pragma once
// The geometry of an organ's pieces, and what cuts changed in it.

#include <optional>

#include "server/physics/organs/organ.h"
#include "server/physics/surface_edit.h"
#include "server/physics/topology.h"

namespace prosector {

/// Returns a piece's tetrahedra, with their skin as the surface, walls of cuts as inner, or its part of the
/// sheet. While no cut is in force that is the compiled mesh. What is no piece any more is one tetrahedron or
/// cell without a surface.
Anatomy anatomy_of(const Organ& organ, const OrganPiece& piece, Numbering& numbering);
/// Returns the surface alone.
PieceSurface surface_of(const Organ& organ, const OrganPiece& piece);

/// Returns what the changes since the last regroup() or follow() did to a mesh, where they are cuts in one
/// piece that nothing came off.
std::optional<PieceEdit> cut_in_one_piece(const Organ& organ);
/// Returns what that edit, before follow(), did to the surface of the piece, which had been cut before.
/// `surface` and `numbering`: what it had.
SurfaceEdit surface_edit(const Organ& organ, const PieceEdit& edit, const TriangleMesh& surface,
                         const Numbering& numbering);

/// Returns the edit from the mesh that anatomy_of() gave of the body before that regroup() to the one that it
/// gives now; none where it wasn't or isn't a piece.
std::optional<PieceEdit> edit_since(const Organ& organ, const Regrouped& then, const OrganPiece& piece);
/// Returns the edit from the surface that a body of tetrahedra had, with its numbering, to the one that it
/// has now. Returns none where one of them is the compiled one.
std::optional<SurfaceEdit> surface_edit_since(const Organ& organ, const Regrouped& then,
                                              const OrganPiece& piece, const TriangleMesh& surface,
                                              const Numbering& numbering);

}  // namespace prosector
