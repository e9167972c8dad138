#pragma once
// Coordinates of overlays over a view, in points (DrawList::scale).

#include "client/view/draw_list.h"

namespace prosector {

/// Height in points of the band at the lower border that is reserved for messages.
inline constexpr double message_band = 48;

struct OverlayFrame {
  double width, height;  // of the view, points
  double lowest;         // lower limit of overlays, points from the top; the time bar is below it

  OverlayFrame(const DrawCamera& camera, double scale)
      : width(camera.width / scale), height(camera.height / scale), lowest(height) {}
  /// Takes the size from the list's first camera.
  explicit OverlayFrame(const DrawList& list) : OverlayFrame(list.cameras.front(), list.scale) {
    lowest -= list.strip;
  }

  /// Converts points from the top left to the normalised device coordinates of an overlay line.
  Vec3 at(double x, double y) const { return {2 * x / width - 1, 1 - 2 * y / height, 0}; }
};

}  // namespace prosector
