#pragma once
// Render meshes of bodies' surfaces.

#include <memory>
#include <span>

#include "client/view/draw_list.h"
#include "common/mesh.h"

namespace prosector {

/// Creates the render mesh of a rigid body's surface, with the id `mesh_id`. Normals are smooth, except
/// across sharp edges.
std::shared_ptr<DrawMesh> rigid_mesh(const TriangleMesh& surface, std::uint64_t mesh_id);

/// Creates the render mesh of a soft body's surface at rest, with smooth normals everywhere. It stores the
/// rest shape, so that textures stick to the tissue. A rope, whose surface is only its axis, becomes a tube
/// of `tube_diameter` metres; 0: not a rope.
std::shared_ptr<DrawMesh> soft_mesh(const TriangleMesh& rest, double tube_diameter, std::uint64_t mesh_id);

/// Updates a mesh that soft_mesh() created to the surface's current vertex positions (m, world frame), and
/// its normals. `tube_diameter`, m, is that of a rope; 0: not a rope.
void move_soft_mesh(std::span<const Eigen::Vector3f> surface, double tube_diameter, DrawMesh& mesh);

}  // namespace prosector
