#pragma once
// Springs and bends of a sheet's cells, see spring_network.h for their constants.

#include <span>
#include <vector>

#include "server/physics/mechanics/soft/base/mesh_edit.h"
#include "server/physics/mechanics/soft/springs/spring_network.h"

namespace prosector::soft {

/// Creates the springs and bending elements of a sheet's cells. Springs are in the order of their nodes.
/// Bending elements about edges come first, in the order of the edges, then those along lines of three nodes,
/// in the order of their nodes.
SpringNetwork make_sheet_springs(const SoftMaterial& material, const Anatomy& sheet);

/// Updates a sheet's springs and bending elements after a cut or an undo changed its geometry to `sheet`. No
/// spring may have been left out for zero length. Bitwise equal to a rebuild. `kept`: the nodes that remain,
/// with their new indices. `touched`: indices after the change of the corners of cells and triangles that
/// were added or removed. Returns the nodes, ascending, of springs and bending elements that may have been
/// added, removed or changed.
std::vector<std::uint32_t> follow_sheet(const SoftMaterial& material, const Anatomy& sheet, const Kept& kept,
                                        std::span<const std::uint32_t> touched, SpringNetwork& springs);

}  // namespace prosector::soft
