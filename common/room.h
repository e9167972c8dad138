#pragma once
// The room around every scene, as it is drawn and as it collides.

namespace prosector {

struct RoomShape {
  double width = 7, depth = 7, height = 3;  // m; centred on the origin, floor at y = 0
};

}  // namespace prosector
