#pragma once
// Walls, floor and ceiling around the scene.

#include <vector>

#include "client/view/draw_list.h"
#include "common/room.h"

namespace prosector {

/// Creates the items of floor, walls and ceiling around the scene. All face inwards, so that none hides the
/// room from outside. The floor consists of square tiles, so that the renderer can find those that the lamp
/// reaches. Each item gets a mesh id, from `first_mesh_id` on.
std::vector<DrawItem> room_items(std::uint64_t first_mesh_id, const RoomShape& shape = {});

}  // namespace prosector
