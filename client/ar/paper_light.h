#pragma once
// Estimates brightness and colour of the light on a board from the white paper around its tags.

#include <optional>

#include "common/image.h"
#include "drivers/camera/base/lens.h"
#include "drivers/camera/tags/board.h"

namespace prosector {

/// Returns brightness and colour of the white paper around a board's tags in an undistorted camera image: the
/// median of linear RGB, where 1 is white on the screen. `straight` is the image's lens model, `camera_board`
/// the board's pose in the camera frame. Returns nullopt if too little of the board is in the image.
std::optional<Vec3> paper_light(const Image& picture, const Lens& straight, const Board& board,
                                const Pose& camera_board);

}  // namespace prosector
