#pragma once
// Conversion of an OpenXR eye to a render camera.

#include "client/view/draw_list.h"

namespace prosector {

/// Pose and field of view of one eye of a headset. The four borders of the view are angles from straight
/// ahead, rad, positive to the right and up.
struct EyeView {
  Pose pose;
  double left = 0, right = 0, up = 0, down = 0;
};

/// Returns whether a frame can be rendered for the eye: its pose is finite, its four angles are within ±90°,
/// and its field of view is not empty.
bool is_usable(const EyeView& eye);

/// Returns the eye's render camera with an off-axis frustum. Its viewport is `width` × `height` pixels, and
/// begins `x` pixels from the frame's left border.
DrawCamera camera_of(const EyeView& eye, int x, int width, int height);

}  // namespace prosector
