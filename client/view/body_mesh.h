#pragma once
// Bodies' surfaces as something to draw.

#include <memory>

#include "client/view/draw_list.h"
#include "common/mesh.h"

namespace prosector {

/// Sharp edges stay sharp.
std::shared_ptr<DrawMesh> rigid_mesh(const TriangleMesh& surface, std::uint64_t mesh_id);

/// Smooth everywhere; keeps the rest shape, so that texture sticks to the tissue.
std::shared_ptr<DrawMesh> soft_mesh(const TriangleMesh& rest, std::uint64_t mesh_id);

}  // namespace prosector
