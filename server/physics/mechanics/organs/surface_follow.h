#pragma once
// Surface edits of a piece after a cut or an undo.

#include <functional>

#include "server/physics/base/surface_edit.h"
#include "server/physics/mechanics/cutting/skin.h"
#include "server/physics/mechanics/organs/organ_parts.h"

namespace prosector::organs {

/// Returns the changes from a piece's previous surface `before` to its current one, after a cut or an undo.
/// `slots`: slots of the organ's `skin` whose triangles may have changed or moved to another piece. `nodes`:
/// the piece's node ids, ascending; `in_piece`: whether a tetrahedron is in the piece. `numbering`: permanent
/// numbers of the previous surface. `first_vertex` and `first_triangle`: numbers of the skin's slot 0.
SurfaceEdit edit_of_surface(const cutting::TetComplex& complex, const cutting::Skin& skin,
                            std::span<const cutting::NodeId> nodes,
                            const std::function<bool(cutting::TetId)>& in_piece,
                            std::vector<std::uint32_t> slots, const TriangleMesh& before,
                            const Numbering& numbering, std::uint32_t first_vertex,
                            std::uint32_t first_triangle);

/// Returns the changes between two complete surfaces of a piece of a cut sheet, which are rebuilt after each
/// change. Entries with the same permanent number are compared. `hung`: embedding of the vertices of `now`.
/// All new triangles count as outer, since sheets have no inner faces.
SurfaceEdit edit_between(const TriangleMesh& before, const Numbering& numbered_before,
                         const TriangleMesh& now, const SparseMap& hung, const Numbering& numbered);

}  // namespace prosector::organs
