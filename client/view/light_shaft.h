#pragma once
// The shaft of light that a lamp sends onto a part.

#include <memory>

#include "client/view/draw_list.h"

namespace prosector {

/// Makes a cone of unit height from the origin along −z, its base of unit radius; narrow at the lamp, not a
/// point.
std::shared_ptr<const DrawMesh> shaft_mesh(std::uint64_t mesh_id);

/// Adds a shaft from `lamp` (m, world frame) that takes in the ball around the part.
void add_light_shaft(DrawList& list, const std::shared_ptr<const DrawMesh>& shaft, const Vec3& lamp,
                     const Vec3& color, const Vec3& part_middle, double part_radius);

}  // namespace prosector
