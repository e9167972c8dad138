#pragma once
// The surface of a piece after a cut, or what takes one back, as what that changed in its list.

#include <functional>

#include "server/physics/cutting/skin.h"
#include "server/physics/organs/organ_parts.h"
#include "server/physics/surface_edit.h"

namespace prosector {

/// Returns the edit from the surface that skinned() made before to the one that it would make now. `slots`:
/// those of the skin's triangles that may have become others, or another piece's; `nodes`: the piece's,
/// ascending.
SurfaceEdit edit_of_surface(const TetComplex& complex, const Skin& skin, std::span<const NodeId> nodes,
                            const std::function<bool(TetId)>& in_piece, std::vector<std::uint32_t> slots,
                            const TriangleMesh& before, const Numbering& numbering,
                            std::uint32_t first_vertex, std::uint32_t first_triangle);

/// Returns the edit between two surfaces that are both there: those of a sheet, whose geometry is made whole.
/// It leaves inner faces out.
SurfaceEdit edit_between(const TriangleMesh& before, const Numbering& numbered_before,
                         const TriangleMesh& now, const SparseMap& hung, const Numbering& numbered);

}  // namespace prosector
