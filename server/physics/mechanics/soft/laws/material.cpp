#include "server/physics/mechanics/soft/laws/material.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/error.h"

namespace prosector::soft {
namespace {

Material make_material(double youngs_modulus, double poisson_ratio, double fiber_stiffness,
                       const Vec3& fiber_direction) {
  Material material = lame(youngs_modulus, poisson_ratio);
  if (!(fiber_stiffness >= 0) || !std::isfinite(fiber_stiffness))
    throw InputError(fmt::format("fiber_stiffness is {}; allowed: 0 or more, in Pa", fiber_stiffness));
  const double length = fiber_direction.norm();
  if (!(length > 1e-9) || !std::isfinite(length))
    throw InputError("fiber_direction is zero or not finite; allowed: a vector of any other length");
  material.fiber_stiffness = fiber_stiffness;
  material.fiber = fiber_direction / length;
  return material;
}

/// Limits λ, so that XPBD's sweeps, XPBD's energy and the implicit fallback steps use the same law.
void bound_for_xpbd(Materials& materials) {
  for (Material& m : materials.kinds) m.lame.lambda = std::min(m.lame.lambda, most_xpbd_lambda * m.lame.mu);
}

Material make_material(const RegionDesc& region, const SoftMaterial& body) {
  return make_material(region.youngs_modulus == 0 ? body.youngs_modulus : region.youngs_modulus,
                       region.poisson_ratio < 0 ? body.poisson_ratio : region.poisson_ratio,
                       region.fiber_stiffness < 0 ? body.fiber_stiffness : region.fiber_stiffness,
                       region.fiber_direction.isZero(0) ? body.fiber_direction : region.fiber_direction);
}

bool contains(const RegionDesc& region, const Vec3& p) {
  const Vec3 from = p - region.center;
  if (region.size.isZero(0)) return from.norm() <= region.radius;
  return (from.array().abs() <= region.size.array() / 2).all();
}

}  // namespace

Lame lame(double youngs_modulus, double poisson_ratio) {
  if (!(youngs_modulus > 0) || !std::isfinite(youngs_modulus)) {
    throw InputError(fmt::format("youngs_modulus is {}; allowed: positive, in Pa", youngs_modulus));
  }
  if (!(poisson_ratio > -1 && poisson_ratio < 0.5)) {
    throw InputError(
        fmt::format("poisson_ratio is {}; allowed: above -1, below 0.5 (at 0.5 the volume cannot change)",
                    poisson_ratio));
  }
  return {youngs_modulus * poisson_ratio / ((1 + poisson_ratio) * (1 - 2 * poisson_ratio)),
          youngs_modulus / (2 * (1 + poisson_ratio))};
}

Materials Materials::at(std::span<const std::uint32_t> source) const {
  Materials out = *this;
  if (kind.empty()) return out;
  out.kind.clear();
  for (const std::uint32_t tet : source) out.kind.push_back(kind[tet]);
  return out;
}

void Materials::follow(const SoftMaterial& material, const TetMesh& mesh, const MeshEdit& edit,
                       std::size_t each) {
  if (kind.empty()) return;
  edit.kept_tets.carry(kind, each);
  for (const std::size_t tet : edit.tets)
    std::fill_n(kind.begin() + static_cast<std::ptrdiff_t>(each * tet), each,
                soft::kind_of(material, mesh, tet));
}

std::uint32_t kind_of(const SoftMaterial& material, const TetMesh& mesh, std::size_t tet) {
  Vec3 middle = Vec3::Zero();
  for (const std::uint32_t node : mesh.tets[tet]) middle += mesh.positions[node] / 4;
  std::uint32_t kind = 0;
  for (std::uint32_t r = 0; r < material.regions.size(); ++r)
    if (contains(material.regions[r], middle)) kind = r + 1;
  return kind;
}

Materials make_materials(const SoftMaterial& material, const TetMesh& mesh, bool for_xpbd) {
  Materials out = make_material(material.youngs_modulus, material.poisson_ratio, material.fiber_stiffness,
                                material.fiber_direction);
  for (std::size_t r = 0; r < material.regions.size(); ++r) {
    try {
      out.kinds.push_back(make_material(material.regions[r], material));
    } catch (const InputError& error) {
      throw InputError(fmt::format("region {}: {}", r + 1, error.what()));
    }
  }
  if (for_xpbd) bound_for_xpbd(out);
  if (material.regions.empty()) return out;
  out.kind.reserve(mesh.tets.size());
  for (std::size_t tet = 0; tet < mesh.tets.size(); ++tet) out.kind.push_back(kind_of(material, mesh, tet));
  return out;
}

}  // namespace prosector::soft
