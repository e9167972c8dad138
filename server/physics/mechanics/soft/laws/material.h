#pragma once
// Materials of a body's tetrahedra: the body's own constants and those of its regions.

#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh.h"
#include "common/scene/scene.h"
#include "server/physics/mechanics/soft/base/mesh_edit.h"

namespace prosector::soft {

/// Lamé constants λ and μ of an isotropic elastic material (Pa). From Young's modulus E and Poisson's ratio
/// ν: λ = Eν/((1+ν)(1−2ν)), μ = E/(2(1+ν)).
struct Lame {
  double lambda;  // Pa
  double mu;      // Pa
};
/// Returns the Lamé constants for Young's modulus E (Pa) and Poisson's ratio ν. Throws InputError unless E >
/// 0 and −1 < ν < ½.
Lame lame(double youngs_modulus, double poisson_ratio);

struct Material {
  Lame lame;
  double fiber_stiffness = 0;                           // Pa
  Vec3 fiber = Vec3::UnitX();                           // unit: fibre direction in the rest shape
  Material(const Lame& constants) : lame(constants) {}  // NOLINT: a material without fibres
};

/// Distinct materials of a body, the first of which is the body's and the others its regions', and the index
/// of the material of each tetrahedron or element.
struct Materials {
  std::vector<Material> kinds;                    // the first is the body's own
  std::vector<std::uint32_t> kind;                // by element; empty: all elements have the first
  Materials(const Material& all) : kinds{all} {}  // NOLINT: the same material everywhere
  Materials(const Lame& all) : kinds{all} {}      // NOLINT

  std::size_t kind_of(std::size_t e) const { return kind.empty() ? 0 : kind[e]; }
  const Material& of(std::size_t e) const { return kinds[kind_of(e)]; }
  /// Returns the same materials for elements that were made from some of the tetrahedra: source[e] is the
  /// index of the tetrahedron of element e.
  Materials at(std::span<const std::uint32_t> source) const;
  /// Updates the material of each element after `edit` changed the mesh to `mesh`, where each tetrahedron has
  /// `each` elements. New and changed tetrahedra get the material of the region in `material` that contains
  /// their centre.
  void follow(const SoftMaterial& material, const TetMesh& mesh, const MeshEdit& edit, std::size_t each = 1);
};

/// Upper bound of λ/μ for bodies under position-based dynamics (XPBD), the ratio at Poisson's ratio 0.499.
/// Beyond it, one solver sweep hardly changes a body's shape.
inline constexpr double most_xpbd_lambda = 499;

/// Returns the index of the material of the tetrahedron `tet` of `mesh`. It is 1 plus the index of the last
/// region in `material` that contains the tetrahedron's centre. If none does it is 0, the body's own
/// material.
std::uint32_t kind_of(const SoftMaterial& material, const TetMesh& mesh, std::size_t tet);

/// Creates the materials of a body and its regions, and assigns one to each tetrahedron of `mesh` (world
/// frame) by its centre. `for_xpbd`: limits λ for position-based dynamics. Throws InputError that names the
/// region and the allowed values for constants out of range.
Materials make_materials(const SoftMaterial& material, const TetMesh& mesh, bool for_xpbd = false);

}  // namespace prosector::soft
