#pragma once
// Location of points in tissue.

#include <optional>
#include <span>
#include <vector>

#include "server/physics/mechanics/organs/locate.h"
#include "server/physics/stations/dissecting/blade_grip.h"
#include "server/physics/world/bodies.h"

namespace prosector {

/// A solid near a box, with a point locator.
struct TissueNear {
  std::size_t body = 0;  // soft body
  Locator locator;
};

/// Returns the bounding box of both lists of points.
Aabb swept_box(std::span<const Vec3> from, std::span<const Vec3> to);
/// Returns the touchable tissue near a box.
std::vector<TissueNear> tissue_near(const Bodies& bodies, const Aabb& box);
/// Returns the tissue that contains a point of that box, and the material point; the rest of the grip is
/// unset.
std::optional<BladeGrip> tissue_at(std::span<const TissueNear> tissue, const Vec3& point);

}  // namespace prosector
