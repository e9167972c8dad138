#pragma once
// Conversion of an OpenXR eye to a render camera.

#include "client/view/draw_list.h"

namespace prosector {

/// Pose and field of view of an eye: angles from straight ahead, rad, right and up positive.
struct EyeView {
  Pose pose;
  double left = 0, right = 0, up = 0, down = 0;
};

/// Reports whether a frame can be rendered for the eye: all values are finite and its field of view is not
/// empty.
bool is_usable(const EyeView& eye);

/// Returns the eye's off-axis camera. Its image begins `x` pixels from the left.
DrawCamera camera_of(const EyeView& eye, int x, int width, int height);

}  // namespace prosector
