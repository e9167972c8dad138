#pragma once
// Dimensions of the room around every scene, used for drawing and for collision.

namespace prosector {

struct RoomShape {
  double width = 7, depth = 7, height = 3;  // m; centred on the origin, floor at y = 0
};

}  // namespace prosector
