#pragma once
// What SoftBody's constructor checks and computes once.

#include <vector>

#include "common/mesh.h"
#include "common/scene/scene.h"
#include "server/physics/surface_edit.h"

namespace prosector {

/// Each throws InputError that names the body, what is wrong and what is allowed.
[[noreturn]] void refuse(const SoftDesc& desc, const std::string& what);
void require(bool ok, const SoftDesc& desc, const std::string& what);
void check_constants(const SoftDesc& desc);
void check_mesh(const SoftDesc& desc, const Anatomy& anatomy);

/// kg of each node, from its volume (m³); see SoftBody::least_mass_share.
VecX lumped_mass(double density, const VecX& volume);
/// m, of the box around the nodes at x (3n).
double bounding_diagonal(const VecX& x);

/// N/m per node from the attachments' spheres; a node in several takes the stiffest. `volume`: m³.
VecX attachment_stiffness(const std::vector<AttachDesc>& attach, const VecX& rest, const VecX& volume);

/// m² of each surface vertex: a third of its triangles; on a rope its share of the mantle.
std::vector<double> vertex_areas(const Anatomy& anatomy);
/// Of a solid: to those of the surface, which took the change in.
void follow_vertex_areas(const TriangleMesh& surface, const SurfaceEdit& edit, std::vector<double>& areas);

}  // namespace prosector
