#pragma once
// The screen as a window into the room for moving eyes, or a view that pans with the face.
//
// Off-axis frusta as in Kooima, "Generalized Perspective Projection" (2008). The screen's frame: origin at
// its centre, x right, y up, z towards the viewer.

#include "client/view/draw_list.h"

namespace prosector {

/// Eye position relative to the displayed view.
struct WindowLook {
  Vec3 eye = Vec3::UnitZ();  // m, in the screen's frame: midpoint of the eyes
  double height = 0.3;       // m, height of the view on the screen
  bool pans = false;         // the eyes pan the view; else the screen is a window
};

/// Returns the camera of an eye (m, in the screen's frame) that sees the room through a rectangle.
/// `room_screen`: pose of its centre in the room; `size`: width and height, m. An eye nearer than 2 cm, or
/// behind the screen, is moved to 2 cm.
DrawCamera camera_through(const Pose& room_screen, const Eigen::Vector2d& size, const Vec3& eye);

/// Returns the eye position before a view of this height at which the window mode shows the same as a plain
/// camera; `fov` is vertical, rad.
Vec3 resting_eye(double fov, double height);

/// Returns the camera for the eyes instead of `rest`, a symmetric camera. The screen is `distance` (m) ahead
/// of `rest` and as large as the view there. A metre before the screen is scaled like a metre on it.
DrawCamera look_through(const DrawCamera& rest, double distance, const WindowLook& look);

}  // namespace prosector
