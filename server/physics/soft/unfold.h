#pragma once
// Shapes that no force leads out of: measures that tell them, and the way out.

#include "common/mesh.h"
#include "server/physics/soft/soft_body.h"

namespace prosector {

/// Share of the rest volume: what has less is as good as inside out.
inline constexpr double flat = 1e-2;
/// Returns the share of the mesh's rest volume in tetrahedra that at node positions x (3n, m) have no more
/// than `least` of their own volume. These are inside out, or flat. 0 for sheets and ropes, which have no
/// tetrahedra.
double inverted_share(const TetMesh& mesh, const VecX& x, double least = flat);

/// Returns the mesh's volume at x over that at rest, below 0 where it is inside out; 1 for sheets and ropes.
double volume_share(const TetMesh& mesh, const VecX& x);

/// Finds the rotation of the rigid motion that takes the rest shape closest to x (Horn 1987). `rest`, x: 3n,
/// m; `mass`: n, kg.
Mat3 best_rotation(const VecX& rest, const VecX& mass, const VecX& x);

/// Tells whether the body as a whole is turned by more than `angle` (rad) from its rest pose and its law is
/// for small rotations. Returns false for laws that turn along.
bool turned_by(const SoftBody& body, double angle, const VecX& x);

/// Puts the rest shape where the body is: the rigid motion that fits best, at its momentum. `turn`: to the
/// orientation of best_rotation(), at its angular momentum; else to that of the rest shape, without spin.
/// Sizes as above.
void unfold(const VecX& rest, const VecX& mass, bool turn, SoftBodyState& state);

/// Puts the body's rest shape where it is. Under a law for small rotations it is not turned: it would be
/// taken for bent. A body that is attached goes where it is attached, at rest.
void unfold(const SoftBody& body, SoftBodyState& state);

}  // namespace prosector
