#pragma once
// Estimates brightness and colour of the light on a board from the white paper around its tags.

#include <optional>

#include "common/image.h"
#include "drivers/camera/base/lens.h"
#include "drivers/camera/tags/board.h"

namespace prosector {

/// Returns the median light of the paper in an undistorted image, linear, 1: white on the screen. Returns
/// nullopt if too little of the board is in the image.
std::optional<Vec3> paper_light(const Image& picture, const Lens& straight, const Board& board,
                                const Pose& camera_board);

}  // namespace prosector
