#pragma once
// Walls, floor and ceiling around the scene.

#include <vector>

#include "client/view/draw_list.h"
#include "common/room.h"

namespace prosector {

/// Makes floor, walls and ceiling, all facing inwards, so that none hides the room from outside. The floor
/// consists of square tiles, so that the renderer can find those that the lamp reaches. Uses one mesh id per
/// item, from `first_mesh_id` on.
std::vector<DrawItem> room_items(std::uint64_t first_mesh_id, const RoomShape& shape = {});

}  // namespace prosector
