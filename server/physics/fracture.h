#pragma once
// What a bone may break into. Each of its planes leaves two pieces, bodies of their own that are neither seen
// nor touched until it breaks there; a piece that other planes cut may break further.

#include <functional>

#include "server/physics/model.h"

namespace prosector {

/// Appends the pieces of model.rigid[body] to the model and its scene, in its own frame, from the planes that
/// its description names. `make`: a rigid body of a description and a surface. Throws InputError for a plane
/// that misses the body.
void add_pieces(Model& model, std::size_t body,
                const std::function<RigidModel(const RigidDesc&, TriangleMesh)>& make);

/// What passes through a plane: what both sides need to move as they do, less what acts on them from outside.
struct PlaneLoad {
  Vec3 above = Vec3::Zero(), below = Vec3::Zero();  // N, from outside, on either side
};
/// Returns the force (N) that the part below exerts on the part above, by D'Alembert's principle on both.
/// With forces that don't quite explain the motion, what is left is shared. Accelerations are those of the
/// sides' centres, m/s².
Vec3 force_through(const RigidModel::Fracture& plane, double mass, const Vec3& above_acceleration,
                   const Vec3& below_acceleration, const PlaneLoad& load);

}  // namespace prosector
