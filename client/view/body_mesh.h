#pragma once
// Bodies' surfaces as something to draw.

#include <memory>
#include <span>

#include "client/view/draw_list.h"
#include "common/mesh.h"

namespace prosector {

/// Makes a mesh whose sharp edges stay sharp.
std::shared_ptr<DrawMesh> rigid_mesh(const TriangleMesh& surface, std::uint64_t mesh_id);

/// Makes a mesh that is smooth everywhere; keeps the rest shape, so that texture sticks to the tissue. A
/// rope, whose surface is its axis, is drawn as a tube of `tube_diameter` metres; 0: not a rope.
std::shared_ptr<DrawMesh> soft_mesh(const TriangleMesh& rest, double tube_diameter, std::uint64_t mesh_id);

/// Lays a mesh of soft_mesh() over the surface's vertices where they are now.
void move_soft_mesh(std::span<const Eigen::Vector3f> surface, double tube_diameter, DrawMesh& mesh);

}  // namespace prosector
