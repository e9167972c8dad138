#pragma once
// The screen as a window into the room for moving eyes, or a view that pans with the face.
//
// Off-axis frusta as in Kooima, "Generalized Perspective Projection" (2008). The screen's frame: origin at
// its centre, x right, y up, z towards the viewer.

#include "client/view/draw_list.h"

namespace prosector {

/// Position of the user's eyes in front of a displayed view, and the way in which it changes the view.
struct WindowLook {
  Vec3 eye = Vec3::UnitZ();  // m, in the screen's frame: midpoint of the eyes
  double height = 0.3;       // m, height of the view on the screen
  bool pans = false;         // the eyes pan the view; else the screen is a window
};

/// Returns the camera of an eye that sees the room through a rectangle, the screen. `room_screen`: pose of
/// the rectangle's centre in the room; `size`: its width and height, m; `eye`: m, in the screen's frame. An
/// eye nearer than 2 cm, or behind the screen, is moved to 2 cm before it.
DrawCamera camera_through(const Pose& room_screen, const Eigen::Vector2d& size, const Vec3& eye);

/// Returns the eye position (m, screen's frame) from which the screen as a window shows the same as a plain
/// camera does. `fov`: the camera's vertical field of view, rad; `height`: that of the view on the screen, m.
Vec3 resting_eye(double fov, double height);

/// Returns the camera that replaces `rest`, a symmetric camera, for the user's tracked eyes. The screen is
/// placed `distance` (m) ahead of `rest` in the room, as large as the view there. The eyes' distance from the
/// real screen is scaled like the screen.
DrawCamera look_through(const DrawCamera& rest, double distance, const WindowLook& look);

}  // namespace prosector
