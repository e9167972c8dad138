#pragma once
// Geometry of an organ's pieces, and its changes by cuts.

#include <optional>

#include "server/physics/base/surface_edit.h"
#include "server/physics/base/topology.h"
#include "server/physics/mechanics/organs/organ.h"

namespace prosector::organs {

/// Returns the mesh and the surface of a piece of a cut organ. For a solid, the surface includes the walls of
/// cuts, marked as inner. Returns the compiled mesh while no cut is in force. A piece that was joined to
/// another is represented by a single tetrahedron or sheet cell without a surface. `numbering` receives the
/// permanent numbers of nodes, vertices and triangles; empty if indices are the numbers.
Anatomy anatomy_of(const Organ& organ, const OrganPiece& piece, Numbering& numbering);
/// Returns only the surface of a piece of a cut organ, with its embedding in the piece's nodes and the
/// permanent numbers of its vertices and triangles. Returns the compiled surface while no cut is in force.
PieceSurface surface_of(const Organ& organ, const OrganPiece& piece);

/// Returns the mesh edit for the organ's changes since its last regroup() or follow(). Returns none unless
/// all of them are cuts in one and the same piece that severed nothing. After none, regroup() is needed
/// instead.
std::optional<PieceEdit> cut_in_one_piece(const Organ& organ);
/// Returns the changes of the surface of the piece that `edit` changes, an edit by cut_in_one_piece(). Call
/// before Organ::follow() applies `edit`. The piece must have been cut before. `surface` and `numbering`: its
/// triangles, and their permanent numbers, before the edit.
SurfaceEdit surface_edit(const Organ& organ, const PieceEdit& edit, const TriangleMesh& surface,
                         const Numbering& numbering);

/// Returns the edit from a piece's mesh before a regroup() to its current mesh, so that derived data can be
/// updated. `then`: the result of that regroup(). Returns none if the body was not or is no longer a piece
/// with tetrahedra. Also returns none if the piece is now the uncut compiled mesh with other node indices.
std::optional<PieceEdit> edit_since(const Organ& organ, const Regrouped& then, const OrganPiece& piece);
/// Returns the edit from a tetrahedral piece's surface before a regroup() to its current surface. `then`: the
/// result of that regroup(). `surface` and `numbering`: the previous triangles and their permanent numbers.
/// Returns none for sheets, and if the previous or the current surface is that of the uncut body.
std::optional<SurfaceEdit> surface_edit_since(const Organ& organ, const Regrouped& then,
                                              const OrganPiece& piece, const TriangleMesh& surface,
                                              const Numbering& numbering);

}  // namespace prosector::organs
