#pragma once
// Camera and pointer of a desk user, controlled with mouse, keyboard and gamepad.

#include "client/app/desk/desk_room.h"
#include "client/app/desk/desk_start.h"
#include "client/app/desk/gamepad_user.h"
#include "client/app/desk/held_keys.h"
#include "client/app/desk/orbit_view.h"
#include "client/view/draw_list.h"
#include "client/view/window_view.h"

namespace prosector {

class DeskView {
 public:
  /// Sets the initial view, with the pointer at the lower right of a frame of `width` × `height` pixels,
  /// where it does not cover the anatomy.
  void begin(const DeskStart& start, int width, int height);
  /// Updates view and pointer by an input event of the window. Events without effect on the view are ignored.
  void take(const WindowEvent& event, const DeskRoom& room);
  void advance(double seconds, const GamepadUser& pad);

  /// Moves the view so that the body under the pointer fills most of the frame; large bodies are only
  /// approached. If no body is under the pointer, the view stays.
  void frame_pointed(const DeskRoom& room);

  /// Moves the view so that a box (m, world frame) fills most of the frame. An empty box leaves the view as
  /// it is.
  void frame(const Eigen::AlignedBox3d& box);

  /// Returns the saved view that a key selects: Home or a number key; nullopt if the key selects none.
  std::optional<ViewPlace> view_of(Key key) const;
  /// Moves the eye back until the whole box (m, world frame) is in the frame, unless it is already.
  void make_room_for(const Eigen::AlignedBox3d& box);

  /// Sets the position of the user's eyes in front of a screen that acts as a window into the room; nullopt:
  /// the screen shows a normal view.
  void set_window_look(const std::optional<WindowLook>& look) { look_ = look; }
  /// Makes the view follow this camera independently of mouse and keyboard; nullopt: mouse and keyboard
  /// control the view.
  void follow_camera(const std::optional<DrawCamera>& camera);

  /// Returns whether an animated transition to another view is in progress.
  bool is_under_way() const { return orbit_.is_under_way(); }
  const ViewPlace& place() const { return leading_ ? leading_place_ : orbit_.place(); }
  /// Returns the pose of the view, world frame, regardless of a screen that acts as a window.
  Pose eye() const { return place().pose(); }
  /// Returns the camera with which the frame is rendered. The ray of pointer() starts at this camera.
  DrawCamera camera() const;
  Ray pointer() const;
  const Eigen::Vector2d& pointer_pixel() const { return pointer_; }
  bool is_held(Key key) const { return keys_.is_held(key); }

 private:
  OrbitView orbit_;
  std::optional<WindowLook> look_;
  std::optional<DrawCamera> leading_;  // camera that the view follows; nullopt: orbit_ controls it
  ViewPlace leading_place_;
  double fov_ = 0.8;  // vertical, rad
  std::array<std::optional<ViewPlace>, saved_views> views_{};
  bool flies_ = false;  // rotating moves the target about the eye, not the eye about the target
  HeldKeys keys_;
  int width_ = 1, height_ = 1;                         // size of the frame, pixels
  Eigen::Vector2d pointer_ = Eigen::Vector2d::Zero();  // pixels from the top left
  bool drags_ = false;                                 // with the right button
  double drag_depth_ = 1;                              // m ahead of the eye: depth of the dragged point

  DrawCamera resting_camera() const;
  void press(Key key, const DeskRoom& room);
  void drag(const Eigen::Vector2d& by);
  void turn(const Eigen::Vector2d& by);
  void fly(double seconds, const GamepadUser& pad);
};

}  // namespace prosector
