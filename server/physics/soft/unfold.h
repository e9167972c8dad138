#pragma once
// Shapes that no force leads out of, and the way out.

#include "common/mesh.h"
#include "server/physics/soft/soft_state.h"

namespace prosector {

/// Share of the mesh's rest volume that at node positions x (3n) is inside out, or flat as good as.
double inverted_share(const TetMesh& mesh, const VecX& x);

/// See SoftBody::unfold. `rest` 3n, `mass` n.
void unfold(const VecX& rest, const VecX& mass, SoftBodyState& state);

}  // namespace prosector
