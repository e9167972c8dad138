#pragma once
// Surface edits of a piece after a cut or an undo.

#include <functional>

#include "server/physics/base/surface_edit.h"
#include "server/physics/mechanics/cutting/skin.h"
#include "server/physics/mechanics/organs/organ_parts.h"

namespace prosector {

/// Returns the edit from the previous surface by skinned() to the current one. `slots`: skin triangles that
/// may have changed or moved to another piece. `nodes`: of the piece, ascending.
SurfaceEdit edit_of_surface(const TetComplex& complex, const Skin& skin, std::span<const NodeId> nodes,
                            const std::function<bool(TetId)>& in_piece, std::vector<std::uint32_t> slots,
                            const TriangleMesh& before, const Numbering& numbering,
                            std::uint32_t first_vertex, std::uint32_t first_triangle);

/// Returns the edit between two surfaces of a sheet, whose geometry is always rebuilt completely. Ignores
/// inner faces.
SurfaceEdit edit_between(const TriangleMesh& before, const Numbering& numbered_before,
                         const TriangleMesh& now, const SparseMap& hung, const Numbering& numbered);

}  // namespace prosector
