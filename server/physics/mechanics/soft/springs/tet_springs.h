#pragma once
// Springs along the edges of tetrahedra, see spring_network.h for their constants.

#include <optional>

#include "server/physics/mechanics/soft/base/mesh_edit.h"
#include "server/physics/mechanics/soft/laws/material.h"
#include "server/physics/mechanics/soft/springs/spring_network.h"

namespace prosector {

/// Creates the springs of tetrahedra, in the order of their nodes.
SpringNetwork make_tet_springs(const SoftDesc& desc, const TetMesh& mesh);

/// Returns the additional λ that the tetrahedra need (μ is 0); none if they need none.
std::optional<Materials> volume_springs(const SoftDesc& desc, const TetMesh& mesh);

/// Updates the springs after an edit of `mesh`. No spring may have been dropped. Bitwise equal to a rebuild.
void follow_tet_springs(const SoftDesc& desc, const TetMesh& mesh, const MeshEdit& edit,
                        SpringNetwork& springs);

}  // namespace prosector
