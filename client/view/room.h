#pragma once
// Walls and floor around the scene, for a sense of place. Purely drawn: nothing collides with it.

#include <vector>

#include "client/view/draw_list.h"

namespace prosector {

struct RoomShape {
  double width = 7, depth = 7, height = 3;  // m; centred on the origin, floor at y = 0
};

/// Floor and four walls, all facing inwards, so that none hides the room from outside. The floor comes in
/// tiles, so that the renderer can tell those that the lamp reaches. Uses a mesh id an item, from
/// `first_mesh_id`.
std::vector<DrawItem> room_items(std::uint64_t first_mesh_id, const RoomShape& shape = {});

}  // namespace prosector
