#pragma once
// The shaft of light from a lamp to a part.

#include <memory>

#include "client/view/draw_list.h"

namespace prosector {

/// Creates the render mesh of a light shaft: a truncated cone of unit height from the origin along −z, with a
/// base of unit radius.
std::shared_ptr<const DrawMesh> shaft_mesh(std::uint64_t mesh_id);

/// Adds a visible shaft of light from `lamp` to a part of the anatomy. It encloses the part's bounding
/// sphere, given by `part_middle` and `part_radius`. Positions are in m, world frame; `shaft` is a mesh of
/// shaft_mesh().
void add_light_shaft(DrawList& list, const std::shared_ptr<const DrawMesh>& shaft, const Vec3& lamp,
                     const Vec3& color, const Vec3& part_middle, double part_radius);

}  // namespace prosector
