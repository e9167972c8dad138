#pragma once
// Follows places from one picture to another by their optical flow (Lucas and Kanade 1981, in pyramids after
// Bouguet 2000).

#include <optional>
#include <span>
#include <vector>

#include "drivers/camera/grey_image.h"
#include "drivers/camera/lens.h"

namespace prosector {

/// Returns where each place went; nothing where it is lost, or misses its start when it is followed
/// back. Both pictures must have one size.
std::vector<std::optional<Vec2>> follow_places(const GreyImage& from, const GreyImage& to,
                                               std::span<const Vec2> places);

}  // namespace prosector
