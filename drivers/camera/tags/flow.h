#pragma once
// Tracks points from one image to another by optical flow (Lucas and Kanade 1981, in pyramids after Bouguet
// 2000).

#include <optional>
#include <span>
#include <vector>

#include "drivers/camera/base/grey_image.h"
#include "drivers/camera/base/lens.h"

namespace prosector {

/// Tracks the points `places` (pixels) from one image to another by optical flow. Returns the new position of
/// each point, or nothing for a point that is lost or that tracking back does not return to its start. Both
/// images must have the same size.
std::vector<std::optional<Vec2>> follow_places(const GreyImage& from, const GreyImage& to,
                                               std::span<const Vec2> places);

}  // namespace prosector
