#pragma once
// Fracture pieces of bones. Each fracture plane gives two pieces, which are separate bodies, invisible and
// intangible until the bone breaks there. A piece that other planes intersect may break further.

#include <functional>

#include "server/physics/world/model.h"

namespace prosector {

/// Appends the pieces of model.rigid[body], by the fracture planes in its description, to the model and its
/// scene, in the body's frame. `make`: creates a rigid body from a description and a surface. Throws
/// InputError for a plane that misses the body.
void add_pieces(Model& model, std::size_t body,
                const std::function<RigidModel(const RigidDesc&, TriangleMesh)>& make);

/// External loads on both sides of a fracture plane.
struct PlaneLoad {
  Vec3 above = Vec3::Zero(), below = Vec3::Zero();  // N, on each side
};
/// Returns the force (N) of the part below on the part above, by D'Alembert's principle on both sides. If
/// forces and motion don't quite match, the residual is shared. Accelerations are those of the sides'
/// centres, m/s².
Vec3 force_through(const RigidModel::Fracture& plane, double mass, const Vec3& above_acceleration,
                   const Vec3& below_acceleration, const PlaneLoad& load);

}  // namespace prosector
