#pragma once
// Location of points in tissue.

#include <optional>
#include <span>
#include <vector>

#include "server/physics/mechanics/organs/locate.h"
#include "server/physics/stations/dissecting/blade_grip.h"
#include "server/physics/world/bodies.h"

namespace prosector {

/// A soft solid whose box is near a searched box, with a locator that finds which of its tetrahedra contains
/// a point.
struct TissueNear {
  std::size_t body = 0;  // soft body
  organs::Locator locator;
};

/// Returns the smallest axis-aligned box that contains all points of both lists.
collision::Aabb swept_box(std::span<const Vec3> from, std::span<const Vec3> to);
/// Returns the solids near a box that can be touched, each with a point locator.
std::vector<TissueNear> tissue_near(const Bodies& bodies, const collision::Aabb& box);
/// Returns the soft body that contains the point, and the material point there, as a BladeGrip whose other
/// members are unset. Returns none if no tissue contains the point. `tissue` must have been found for a box
/// that contains the point.
std::optional<organs::BladeGrip> tissue_at(std::span<const TissueNear> tissue, const Vec3& point);

}  // namespace prosector
