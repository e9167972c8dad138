#pragma once
// Fracture pieces of bones. Each fracture plane gives two pieces, which are separate bodies, invisible and
// intangible until the bone breaks there. A piece that other planes intersect may break further.

#include <functional>

#include "server/physics/world/model.h"

namespace prosector {

/// Appends the fragments of model.rigid[body] to the model and its scene, in the body's frame. Each fracture
/// plane in the body's description gives two. `make` creates a rigid body from a description and a surface.
/// Throws InputError for a plane that misses the body.
void add_pieces(Model& model, std::size_t body,
                const std::function<RigidModel(const RigidDesc&, TriangleMesh)>& make);

/// Resultants of the external forces on the two sides of a fracture plane.
struct PlaneLoad {
  Vec3 above = Vec3::Zero(), below = Vec3::Zero();  // N, on each side
};
/// Returns the force (N) that the side below a fracture plane exerts on the side above, computed from each
/// side's acceleration and external load (D'Alembert). If both sides' results differ, the difference is
/// shared. `mass` (kg) is that of the whole body; accelerations are those of the sides' centres, m/s².
Vec3 force_through(const RigidModel::Fracture& plane, double mass, const Vec3& above_acceleration,
                   const Vec3& below_acceleration, const PlaneLoad& load);

}  // namespace prosector
