#pragma once
// Checks and precomputed data of SoftBody's constructor, computed again after a cut.

#include <string>
#include <vector>

#include "common/error.h"
#include "common/mesh.h"
#include "common/scene/scene.h"
#include "server/physics/base/surface_edit.h"

namespace prosector {

/// Throws InputError that names the body, the error and the allowed values, as the other functions here do.
[[noreturn]] void refuse(const SoftDesc& desc, const std::string& what);
void require(bool ok, const SoftDesc& desc, const std::string& what);
void check_constants(const SoftDesc& desc);
void check_mesh(const SoftDesc& desc, const Anatomy& anatomy);

/// Calls make() and adds the body's name to an InputError that make() throws.
template <class T>
auto name_in_errors(const SoftDesc& desc, const T& make) {
  try {
    return make();
  } catch (const InputError& error) {
    refuse(desc, error.what());
  }
}

/// Minimum node mass relative to the mean node mass, for nodes without tetrahedra or with flat ones only:
/// every unknown needs inertia.
inline constexpr double least_mass_share = 1e-6;
/// Returns the mass of each node, kg, from its volume (m³).
VecX lumped_mass(double density, const VecX& volume);
/// Returns the diagonal of the bounding box of node positions x (3n), m.
double bounding_diagonal(const VecX& x);

/// Returns the attachment stiffness per node, N/m, from the attachments' spheres; a node in several spheres
/// gets the largest value. `volume`: m³.
VecX attachment_stiffness(const std::vector<AttachDesc>& attach, const VecX& rest, const VecX& volume);

/// Returns the area of each surface vertex, m²: a third of its triangles; on a rope also its share of the
/// lateral surface.
std::vector<double> vertex_areas(const Anatomy& anatomy);
/// Updates a solid's vertex areas after an edit that was already applied to `surface`.
void follow_vertex_areas(const TriangleMesh& surface, const SurfaceEdit& edit, std::vector<double>& areas);

}  // namespace prosector
