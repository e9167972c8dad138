#pragma once
// A line projected onto a body's surface.

#include <functional>
#include <optional>
#include <vector>

#include "client/view/pick.h"
#include "common/ids.h"

namespace prosector {

/// Returns the first surface point on a ray; if a body is given, of that body only.
using FindSurface = std::function<std::optional<Picked>(const Ray&, std::optional<BodyId>)>;

/// Returns points (m, world frame) on the body along a straight line over its surface, from `behind` before
/// the point to `ahead` beyond it. `along`: unit. The line ends at the body's border.
std::vector<Vec3> draped_line(const FindSurface& find, const Picked& point, const Vec3& along, double behind,
                              double ahead);

}  // namespace prosector
