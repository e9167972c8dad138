#pragma once
// What SoftBody's constructor checks and computes once, and again after a cut.

#include <string>
#include <vector>

#include "common/error.h"
#include "common/mesh.h"
#include "common/scene/scene.h"
#include "server/physics/surface_edit.h"

namespace prosector {

/// Throws InputError that names the body, what is wrong and what is allowed; so do the others here.
[[noreturn]] void refuse(const SoftDesc& desc, const std::string& what);
void require(bool ok, const SoftDesc& desc, const std::string& what);
void check_constants(const SoftDesc& desc);
void check_mesh(const SoftDesc& desc, const Anatomy& anatomy);

/// Calls make(), and has the InputError that it throws name the body.
template <class T>
auto name_in_errors(const SoftDesc& desc, const T& make) {
  try {
    return make();
  } catch (const InputError& error) {
    refuse(desc, error.what());
  }
}

/// Share of the mean node's mass that a node gets to which no tetrahedron, or only flat ones, give any: every
/// unknown needs inertia.
inline constexpr double least_mass_share = 1e-6;
/// Returns kg of each node, from its volume (m³).
VecX lumped_mass(double density, const VecX& volume);
/// Returns the diagonal of the box around the nodes at x (3n), m.
double bounding_diagonal(const VecX& x);

/// Returns N/m per node from the attachments' spheres; a node in several takes the stiffest. `volume`: m³.
VecX attachment_stiffness(const std::vector<AttachDesc>& attach, const VecX& rest, const VecX& volume);

/// Returns m² of each surface vertex: a third of its triangles; on a rope its share of the mantle.
std::vector<double> vertex_areas(const Anatomy& anatomy);
/// Makes a solid's areas those of the surface, which took the edit in.
void follow_vertex_areas(const TriangleMesh& surface, const SurfaceEdit& edit, std::vector<double>& areas);

}  // namespace prosector
