#pragma once
// Which tissue a point is in.

#include <optional>
#include <span>
#include <vector>

#include "server/physics/bodies.h"
#include "server/physics/organs/blade_grip.h"
#include "server/physics/organs/locate.h"

namespace prosector {

/// A solid near some place, with what finds its material there.
struct TissueNear {
  std::size_t body = 0;  // soft
  Locator locator;
};

/// Returns a box around both lists of points.
Aabb swept_box(std::span<const Vec3> from, std::span<const Vec3> to);
/// Returns the tissue that can be touched near a box.
std::vector<TissueNear> tissue_near(const Bodies& bodies, const Aabb& box);
/// Returns which of it a point of that box is in, and where in its material; the rest of the grip is unset.
std::optional<BladeGrip> tissue_at(std::span<const TissueNear> tissue, const Vec3& point);

}  // namespace prosector
