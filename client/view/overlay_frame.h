#pragma once
// Where things stand that lie over a picture. They are laid out in points (DrawList::scale).

#include "client/view/draw_list.h"

namespace prosector {

/// Points at the lower border that messages have for themselves.
inline constexpr double message_band = 48;

struct OverlayFrame {
  double width, height;  // of the picture, points
  double lowest;         // that overlays reach down to, points from the top: below is the time bar's

  OverlayFrame(const DrawCamera& camera, double scale)
      : width(camera.width / scale), height(camera.height / scale), lowest(height) {}
  /// Takes the frame of the list's first camera.
  explicit OverlayFrame(const DrawList& list) : OverlayFrame(list.cameras.front(), list.scale) {
    lowest -= list.strip;
  }

  /// Returns the end of an overlay line: normalised device coordinates of points from the top left.
  Vec3 at(double x, double y) const { return {2 * x / width - 1, 1 - 2 * y / height, 0}; }
};

}  // namespace prosector
