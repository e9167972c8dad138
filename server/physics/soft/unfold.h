#pragma once
// Shapes that no force leads out of, and the way out.

#include "common/mesh.h"
#include "server/physics/soft/integrators/soft_state.h"

namespace prosector {

/// Of the rest volume: less is as good as inside out.
inline constexpr double flat = 1e-2;
/// Share of the mesh's rest volume in tetrahedra that at node positions x (3n) have no more than `least` of
/// their own.
double crushed_share(const TetMesh& mesh, const VecX& x, double least);

/// The mesh's volume at x over that at rest, below 0 where it is inside out; 1 of sheets and ropes.
double volume_share(const TetMesh& mesh, const VecX& x);

/// The rotation of the rigid motion that takes the rest shape closest to x (Horn 1987); sizes as below.
Mat3 best_rotation(const VecX& rest, const VecX& mass, const VecX& x);

/// See SoftBody::unfold. `rest` 3n, `mass` n. `turn`: to the orientation that fits best, spinning as x does;
/// else to that of the rest shape, without spin: a law for small rotations keeps neither.
void unfold(const VecX& rest, const VecX& mass, bool turn, SoftBodyState& state);

}  // namespace prosector
