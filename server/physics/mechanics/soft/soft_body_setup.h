#pragma once
// Checks and precomputed data of SoftBody's constructor, computed again after a cut.

#include <string>
#include <vector>

#include "common/error.h"
#include "common/mesh.h"
#include "common/scene/scene.h"
#include "server/physics/base/surface_edit.h"

namespace prosector::soft {

/// Throws InputError with the name of the soft body `desc` and the text `what`, which describes the error and
/// the allowed values.
[[noreturn]] void refuse(const SoftDesc& desc, const std::string& what);
void require(bool ok, const SoftDesc& desc, const std::string& what);
void check_constants(const SoftDesc& desc);
void check_mesh(const SoftDesc& desc, const Anatomy& anatomy);

/// Calls make() and returns its result. If make() throws InputError, throws it again with the name of the
/// soft body `desc` added to the message.
template <class T>
auto name_in_errors(const SoftDesc& desc, const T& make) {
  try {
    return make();
  } catch (const InputError& error) {
    refuse(desc, error.what());
  }
}

/// Minimum mass of a node relative to the mean node mass. It applies to nodes without tetrahedra or with flat
/// ones only, because each unknown of the equations needs inertia.
inline constexpr double least_mass_share = 1e-6;
/// Returns the mass of each node (n, kg): `density` (kg/m³) times the node's volume (n, m³), which is raised
/// to `least_mass_share` of the mean if it is smaller.
VecX lumped_mass(double density, const VecX& volume);
/// Returns the length of the diagonal (m) of the axis-aligned bounding box of node positions x (3n, m).
double bounding_diagonal(const VecX& x);

/// Returns the attachment stiffness of each node (n, N/m): the attachment's stiffness (N/m⁴) times the node's
/// `volume` (n, m³) for nodes inside its sphere. A node in several spheres gets the largest value; a node
/// outside gets 0. `rest`: rest positions (3n, m).
VecX attachment_stiffness(const std::vector<AttachDesc>& attach, const VecX& rest, const VecX& volume);

/// Returns the area of each surface vertex, m²: a third of the area of its triangles. On a rope it also
/// includes the vertex's share of the rope's lateral surface.
std::vector<double> vertex_areas(const Anatomy& anatomy);
/// Updates `areas` (m², by surface vertex of a solid) after `edit` was applied to `surface`. Recomputes only
/// vertices whose triangles changed.
void follow_vertex_areas(const TriangleMesh& surface, const SurfaceEdit& edit, std::vector<double>& areas);

}  // namespace prosector::soft
