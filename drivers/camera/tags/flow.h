#pragma once
// Tracks points from one image to another by optical flow (Lucas and Kanade 1981, in pyramids after Bouguet
// 2000).

#include <optional>
#include <span>
#include <vector>

#include "drivers/camera/base/grey_image.h"
#include "drivers/camera/base/lens.h"

namespace prosector {

/// Returns the new position of each point. A point gives nothing if it is lost, or if tracking it back misses
/// its start. Both images must have the same size.
std::vector<std::optional<Vec2>> follow_places(const GreyImage& from, const GreyImage& to,
                                               std::span<const Vec2> places);

}  // namespace prosector
