#pragma once
// How bright and of which colour the light on a board is: by the white paper around its tags.

#include <optional>

#include "common/image.h"
#include "drivers/camera/lens.h"
#include "drivers/camera/tags/board.h"

namespace prosector {

/// Returns the median of the paper's light in a straight picture, as a screen shows it (linear, 1: white);
/// nothing where too little of the board is in the picture.
std::optional<Vec3> paper_light(const Image& picture, const Lens& straight, const Board& board,
                                const Pose& camera_board);

}  // namespace prosector
