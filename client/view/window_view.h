#pragma once
// The screen as a window into the room, for eyes that move before it; or a view that the face turns.
//
// Off-axis frusta as in Kooima, "Generalized Perspective Projection" (2008). A screen's frame: from its
// middle x right, y up, z to who looks at it.

#include "client/view/draw_list.h"

namespace prosector {

/// Where the eyes are before a picture.
struct WindowLook {
  Vec3 eye = Vec3::UnitZ();  // m, in the screen's frame: the point between them
  double height = 0.3;       // m, of the picture on the screen
  bool pans = false;         // they turn the view; else the screen is a window
};

/// Returns the camera of an eye (m, in the screen's frame) that sees the room through a rectangle: the
/// middle's pose in the room, width and height, m. An eye nearer than 2 cm, or behind, is taken there.
DrawCamera camera_through(const Pose& room_screen, const Eigen::Vector2d& size, const Vec3& eye);

/// Returns where the eye is, before a picture of that height, from which it looks as it does without any
/// window; `fov` is vertical, rad.
Vec3 resting_eye(double fov, double height);

/// Returns what the eyes see instead of `rest`, a symmetric camera. The screen lies `distance` (m) ahead of
/// that, as large as its picture there; so a metre before the screen is as long as a metre on it.
DrawCamera look_through(const DrawCamera& rest, double distance, const WindowLook& look);

}  // namespace prosector
