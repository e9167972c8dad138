#pragma once
// Materials of a body's tetrahedra: the body's own constants and those of its regions.

#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh.h"
#include "common/scene/scene.h"
#include "server/physics/mechanics/soft/base/mesh_edit.h"

namespace prosector {

/// Lamé constants. From E and ν: λ = Eν/((1+ν)(1−2ν)), μ = E/(2(1+ν)).
struct Lame {
  double lambda;  // Pa
  double mu;      // Pa
};
/// Throws InputError unless E > 0 and −1 < ν < ½.
Lame lame(double youngs_modulus, double poisson_ratio);

struct Material {
  Lame lame;
  double fiber_stiffness = 0;                           // Pa
  Vec3 fiber = Vec3::UnitX();                           // unit: fibre direction in the rest shape
  Material(const Lame& constants) : lame(constants) {}  // NOLINT: a material without fibres
};

/// The distinct materials of a body, and the material of each tetrahedron or element.
struct Materials {
  std::vector<Material> kinds;                    // the first is the body's own
  std::vector<std::uint32_t> kind;                // by element; empty: all elements have the first
  Materials(const Material& all) : kinds{all} {}  // NOLINT: the same material everywhere
  Materials(const Lame& all) : kinds{all} {}      // NOLINT

  std::size_t kind_of(std::size_t e) const { return kind.empty() ? 0 : kind[e]; }
  const Material& of(std::size_t e) const { return kinds[kind_of(e)]; }
  /// Returns the materials of elements made from some of the tetrahedra: source[e] is the tetrahedron of
  /// element e.
  Materials at(std::span<const std::uint32_t> source) const;
  /// Updates the materials after an edit of `mesh`, for all its tetrahedra or for `each` elements per
  /// tetrahedron.
  void follow(const SoftDesc& desc, const TetMesh& mesh, const MeshEdit& edit, std::size_t each = 1);
};

/// λ/μ at ν = 0.499. XPBD limits the ratio to this value, since beyond it one sweep hardly changes a body's
/// shape.
inline constexpr double most_xpbd_lambda = 499;

/// Returns the index of the material of a tetrahedron of `mesh`.
std::uint32_t kind_of(const SoftDesc& desc, const TetMesh& mesh, std::size_t tet);

/// Creates the materials of the tetrahedra of `mesh`, which is in the world frame; for model "xpbd" λ is
/// limited. Throws InputError that names the region and the allowed values for constants out of range.
Materials make_materials(const SoftDesc& desc, const TetMesh& mesh);

}  // namespace prosector
