#pragma once
// Walls, floor and ceiling around the scene, for a sense of place.

#include <vector>

#include "client/view/draw_list.h"
#include "common/room.h"

namespace prosector {

/// Makes floor, walls and ceiling, all facing inwards, so that none hides the room from outside. The floor
/// comes in squares, so that the renderer can tell those that the lamp reaches. Uses a mesh id an item, from
/// `first_mesh_id`.
std::vector<DrawItem> room_items(std::uint64_t first_mesh_id, const RoomShape& shape = {});

}  // namespace prosector
