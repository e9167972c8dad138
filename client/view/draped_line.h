#pragma once
// A line projected onto a body's surface.

#include <functional>
#include <optional>
#include <vector>

#include "client/view/pick.h"
#include "common/ids.h"

namespace prosector {

/// Function that returns the first point at which a ray meets a body's surface; if a body is given, only that
/// body counts. It returns nullopt if there is none.
using FindSurface = std::function<std::optional<Picked>(const Ray&, std::optional<BodyId>)>;

/// Returns points (m, world frame) of a straight line that is projected onto the surface of `point`'s body.
/// The line runs in the direction `along` (unit), from `behind` m before the point to `ahead` m beyond it. It
/// ends early at the body's border.
std::vector<Vec3> draped_line(const FindSurface& find, const Picked& point, const Vec3& along, double behind,
                              double ahead);

}  // namespace prosector
