#pragma once
// Springs and bends of a sheet's cells, see spring_network.h for their constants.

#include <span>
#include <vector>

#include "server/physics/mechanics/soft/base/mesh_edit.h"
#include "server/physics/mechanics/soft/springs/spring_network.h"

namespace prosector {

/// Creates the springs in the order of their nodes. Bends about edges follow, in the order of the edges, then
/// bends along lines, in the order of their nodes.
SpringNetwork make_sheet_springs(const SoftDesc& desc, const Anatomy& sheet);

/// Updates a sheet's springs after a cut or an undone cut. No spring may have been dropped. Bitwise equal to
/// a rebuild from `sheet`. `kept`: the nodes that are kept. `touched`: the present corners of cells and
/// triangles that were added or removed. Returns the nodes, ascending, of springs and bends that may have
/// been added, removed or changed.
std::vector<std::uint32_t> follow_sheet(const SoftDesc& desc, const Anatomy& sheet, const Kept& kept,
                                        std::span<const std::uint32_t> touched, SpringNetwork& springs);

}  // namespace prosector
