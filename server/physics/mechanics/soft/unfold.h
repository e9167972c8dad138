#pragma once
// Inverted shapes from which no elastic force leads back: measures to detect them, and the reset to the rest
// shape.

#include "common/mesh.h"
#include "server/physics/mechanics/soft/soft_body.h"

namespace prosector {

/// Fraction of its rest volume below which a tetrahedron counts as inverted.
inline constexpr double flat = 1e-2;
/// Returns the fraction of the mesh's rest volume in tetrahedra that are inverted or flat at node positions x
/// (3n, m). These have no more than `least` of their rest volume. Returns 0 for sheets and ropes, which
/// have no tetrahedra.
double inverted_share(const TetMesh& mesh, const VecX& x, double least = flat);

/// Returns the ratio of the mesh's volume at x to its rest volume, negative for an inverted mesh; 1 for
/// sheets and ropes.
double volume_share(const TetMesh& mesh, const VecX& x);

/// Returns the rotation of the rigid motion that best fits the rest shape to x (Horn 1987). `rest`, x: 3n, m;
/// `mass`: n, kg.
Mat3 best_rotation(const VecX& rest, const VecX& mass, const VecX& x);

/// Returns whether the body's law is for small rotations and the body as a whole is rotated by more than
/// `angle` (rad) from its rest pose. Returns false for objective laws.
bool rotated_by(const SoftBody& body, double angle, const VecX& x);

/// Resets the body to its rest shape at its current position and keeps its linear momentum. `turn`: rotates
/// the rest shape by best_rotation() and keeps the angular momentum; else uses the rest orientation without
/// angular velocity. Array sizes as above.
void unfold(const VecX& rest, const VecX& mass, bool turn, SoftBodyState& state);

/// Resets the body to its rest shape at its current position. Under a law for small rotations the shape is
/// not rotated, because a rotation would count as strain. An attached body is reset to its rest positions
/// with zero velocity.
void unfold(const SoftBody& body, SoftBodyState& state);

}  // namespace prosector
