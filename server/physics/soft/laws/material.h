#pragma once
// What each tetrahedron of a body is made of: the body's own constants and those of its regions.

#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh.h"
#include "common/scene/scene.h"
#include "server/physics/soft/base/mesh_edit.h"

namespace prosector {

/// Elastic constants as Lamé's. From E and ν: λ = Eν/((1+ν)(1−2ν)), μ = E/(2(1+ν)).
struct Lame {
  double lambda;  // Pa
  double mu;      // Pa
};
/// Throws InputError unless E > 0 and −1 < ν < ½.
Lame lame(double youngs_modulus, double poisson_ratio);

struct Material {
  Lame lame;
  double fiber_stiffness = 0;                           // Pa
  Vec3 fiber = Vec3::UnitX();                           // unit: along the fibres at rest
  Material(const Lame& constants) : lame(constants) {}  // NOLINT: without fibres it is just that
};

/// The few materials there are, and which of them each tetrahedron, or element, has.
struct Materials {
  std::vector<Material> kinds;                    // the first is the body's own
  std::vector<std::uint32_t> kind;                // of each; empty: all the first
  Materials(const Material& all) : kinds{all} {}  // NOLINT: one material is many of the same
  Materials(const Lame& all) : kinds{all} {}      // NOLINT

  std::size_t kind_of(std::size_t e) const { return kind.empty() ? 0 : kind[e]; }
  const Material& of(std::size_t e) const { return kinds[kind_of(e)]; }
  /// Returns the materials of elements made from some of the tetrahedra: source[e] is element e's.
  Materials at(std::span<const std::uint32_t> source) const;
  /// Follows all tetrahedra of `mesh`, which was edited so, or as many elements of each.
  void follow(const SoftDesc& desc, const TetMesh& mesh, const MeshEdit& edit, std::size_t each = 1);
};

/// λ/μ at ν = 0.499: what XPBD takes a larger ratio for, since beyond it one sweep hardly moves a body's
/// shape.
inline constexpr double most_xpbd_lambda = 499;

/// Returns the kind that a tetrahedron of `mesh` is of.
std::uint32_t kind_of(const SoftDesc& desc, const TetMesh& mesh, std::size_t tet);

/// Makes the materials of the tetrahedra of `mesh`, which is in the world frame; for model "xpbd" with its
/// bound on λ. Throws InputError that names the region and what is allowed for constants out of range.
Materials make_materials(const SoftDesc& desc, const TetMesh& mesh);

}  // namespace prosector
