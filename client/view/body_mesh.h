#pragma once
// Render meshes of bodies' surfaces.

#include <memory>
#include <span>

#include "client/view/draw_list.h"
#include "common/mesh.h"

namespace prosector {

/// Makes a mesh with sharp edges preserved.
std::shared_ptr<DrawMesh> rigid_mesh(const TriangleMesh& surface, std::uint64_t mesh_id);

/// Makes a mesh with smooth normals everywhere. Stores the rest shape, so that textures stick to the tissue.
/// A rope, whose surface is its axis, is drawn as a tube of `tube_diameter` metres; 0: not a rope.
std::shared_ptr<DrawMesh> soft_mesh(const TriangleMesh& rest, double tube_diameter, std::uint64_t mesh_id);

/// Updates a mesh of soft_mesh() to the surface's current vertex positions.
void move_soft_mesh(std::span<const Eigen::Vector3f> surface, double tube_diameter, DrawMesh& mesh);

}  // namespace prosector
