#pragma once
// The shaft of light from a lamp to a part.

#include <memory>

#include "client/view/draw_list.h"

namespace prosector {

/// Makes a truncated cone of unit height from the origin along −z, with a base of unit radius.
std::shared_ptr<const DrawMesh> shaft_mesh(std::uint64_t mesh_id);

/// Adds a shaft from `lamp` (m, world frame) that encloses the bounding sphere of the part.
void add_light_shaft(DrawList& list, const std::shared_ptr<const DrawMesh>& shaft, const Vec3& lamp,
                     const Vec3& color, const Vec3& part_middle, double part_radius);

}  // namespace prosector
