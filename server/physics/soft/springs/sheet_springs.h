#pragma once
// The springs and bends of a sheet's cells, see spring_network.h for their constants.

#include <span>
#include <vector>

#include "server/physics/soft/base/mesh_edit.h"
#include "server/physics/soft/springs/spring_network.h"

namespace prosector {

/// Springs in the order of their nodes; then bends about edges, in the order of those, and along lines, in
/// the order of their nodes.
SpringNetwork make_sheet_springs(const SoftDesc& desc, const Anatomy& sheet);

/// Takes a sheet's springs, of which none was dropped, along with a cut or what takes one back: as if made
/// anew of `sheet`, bit for bit. `kept`: of the nodes; `touched`: the corners there now of cells and
/// triangles that came or went. Returns the nodes, ascending, of springs and bends that may have come, gone
/// or changed.
std::vector<std::uint32_t> follow_sheet(const SoftDesc& desc, const Anatomy& sheet, const Kept& kept,
                                        std::span<const std::uint32_t> touched, SpringNetwork& springs);

}  // namespace prosector
