#pragma once
// Springs along the edges of tetrahedra, see spring_network.h for their constants.

#include <optional>

#include "server/physics/mechanics/soft/base/mesh_edit.h"
#include "server/physics/mechanics/soft/laws/material.h"
#include "server/physics/mechanics/soft/springs/spring_network.h"

namespace prosector::soft {

/// Creates springs along the edges of the tetrahedra of a mass-spring solid, in the order of their nodes.
SpringNetwork make_tet_springs(const SoftMaterial& material, const TetMesh& mesh);

/// Returns materials that give tetrahedra of a mass-spring solid the volume stiffness that its springs lack:
/// λ − μ as λ, and 0 as μ. Returns none if no tetrahedron needs any, because `hold_volume` is off or λ ≤ μ
/// everywhere.
std::optional<Materials> volume_springs(const SoftMaterial& material, const TetMesh& mesh);

/// Updates the springs of a mass-spring solid after `edit` changed its mesh to `mesh`. No spring may have
/// been left out for zero length. The result is bitwise equal to a rebuild.
void follow_tet_springs(const SoftMaterial& material, const TetMesh& mesh, const MeshEdit& edit,
                        SpringNetwork& springs);

}  // namespace prosector::soft
