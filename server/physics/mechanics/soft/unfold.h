#pragma once
// Inverted shapes from which no elastic force leads back: measures to detect them, and the reset to the rest
// shape.

#include "common/mesh.h"
#include "server/physics/mechanics/soft/soft_body.h"

namespace prosector::soft {

/// Volume ratio up to which a tetrahedron counts as inverted or flat: its current volume divided by its rest
/// volume.
inline constexpr double flat = 1e-2;
/// Returns the fraction of the mesh's rest volume in tetrahedra that are inverted or flat at node positions x
/// (3n, m): those with at most `least` times their rest volume. Returns 0 for sheets and ropes, which have no
/// tetrahedra.
double inverted_share(const TetMesh& mesh, const VecX& x, double least = flat);

/// Returns the ratio of the mesh's volume at node positions x (3n, m) to its rest volume. It is negative for
/// a mesh turned inside out, and 1 for sheets and ropes, which have no tetrahedra.
double volume_share(const TetMesh& mesh, const VecX& x);

/// Returns the rotation of the rigid motion that best fits the rest positions to the positions x, in
/// mass-weighted least squares (Horn 1987). `rest` and x: 3n, m; `mass`: n, kg.
Mat3 best_rotation(const VecX& rest, const VecX& mass, const VecX& x);

/// Returns whether a body with a law for small rotations is rotated as a whole by more than `angle` (rad)
/// from its rest shape. x: node positions (3n, m). Returns false for objective laws, under which rotation
/// causes no strain.
bool rotated_by(const SoftBody& body, double angle, const VecX& x);

/// Resets a soft body's state to the rest shape at its current centre of mass, and preserves its linear
/// momentum. `rest`: 3n, m; `mass`: n, kg. `turn`: rotates the rest shape by best_rotation() and preserves
/// the angular momentum. Without it, the body gets its rest orientation and no angular velocity.
void unfold(const VecX& rest, const VecX& mass, bool turn, SoftBodyState& state);

/// Resets the body's state to its rest shape at its current position. Under a law for small rotations the
/// shape is not rotated, because a rotation would count as strain. An attached body is reset to its rest
/// positions with zero velocity.
void unfold(const SoftBody& body, SoftBodyState& state);

}  // namespace prosector::soft
