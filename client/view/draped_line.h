#pragma once
// A line laid over a body's surface.

#include <functional>
#include <optional>
#include <vector>

#include "client/view/pick.h"

namespace prosector {

/// Finds what a ray meets first; of one body alone, if it is given.
using FindSurface = std::function<std::optional<Picked>(const Ray&, std::optional<BodyId>)>;

/// Returns places on the body along a straight line over it (m, world frame): from `behind` before the point
/// to `ahead` beyond it. `along`: unit. The line ends where the body does.
std::vector<Vec3> draped_line(const FindSurface& find, const Picked& point, const Vec3& along, double behind,
                              double ahead);

}  // namespace prosector
