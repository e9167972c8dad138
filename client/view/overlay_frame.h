#pragma once
// Coordinates of overlays over a view, in points (DrawList::scale).

#include "client/view/draw_list.h"

namespace prosector {

/// Height, in points, of the band at the view's lower border that is reserved for message lines.
inline constexpr double message_band = 48;

struct OverlayFrame {
  double width, height;  // of the view, points
  double lowest;         // lower limit of overlays, points from the top; the time bar is below it

  OverlayFrame(const DrawCamera& camera, double scale)
      : width(camera.width / scale), height(camera.height / scale), lowest(height) {}
  /// Takes the view's size from the list's first camera, and leaves its lower strip (DrawList::strip) free.
  explicit OverlayFrame(const DrawList& list) : OverlayFrame(list.cameras.front(), list.scale) {
    lowest -= list.strip;
  }

  /// Converts a position in points from the view's top left to the normalised device coordinates of a
  /// DrawLine in the overlay.
  Vec3 at(double x, double y) const { return {2 * x / width - 1, 1 - 2 * y / height, 0}; }
};

}  // namespace prosector
