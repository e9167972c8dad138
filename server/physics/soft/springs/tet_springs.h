#pragma once
// The springs along the edges of tetrahedra, see spring_network.h for their constants.

#include <optional>

#include "server/physics/soft/base/mesh_edit.h"
#include "server/physics/soft/laws/material.h"
#include "server/physics/soft/springs/spring_network.h"

namespace prosector {

/// Makes the springs of tetrahedra, in the order of their nodes.
SpringNetwork make_tet_springs(const SoftDesc& desc, const TetMesh& mesh);

/// Returns the λ that the tetrahedra need besides (μ is 0); none: they need none.
std::optional<Materials> volume_springs(const SoftDesc& desc, const TetMesh& mesh);

/// Takes springs, of which none was dropped, along: as if made anew of `mesh`, which was edited so, bit for
/// bit.
void follow_tet_springs(const SoftDesc& desc, const TetMesh& mesh, const MeshEdit& edit,
                        SpringNetwork& springs);

}  // namespace prosector
