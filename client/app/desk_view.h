#pragma once
// How mouse, keyboard and gamepad move a desk user's eye and pointer.

#include "client/app/desk_room.h"
#include "client/app/desk_start.h"
#include "client/app/gamepad_user.h"
#include "client/app/held_keys.h"
#include "client/app/orbit_view.h"
#include "client/view/draw_list.h"
#include "client/view/window_view.h"

namespace prosector {

class DeskView {
 public:
  /// Begins at the start, with the pointer at the lower right of a picture of that size (pixels), beside what
  /// the start frames.
  void begin(const DeskStart& start, int width, int height);
  /// Takes an event, whether or not it is for the view.
  void take(const WindowEvent& event, const DeskRoom& room);
  void advance(double seconds, const GamepadUser& pad);

  /// Frames what is under the pointer; large things are brought near rather than framed. Over nothing the
  /// view stays.
  void frame_pointed(const DeskRoom& room);

  /// Frames a box (m, world frame); an empty one leaves the view as it is.
  void frame(const Eigen::AlignedBox3d& box);

  /// Returns the view that pressing a key leads to, as it is now; nullopt: to none.
  std::optional<ViewPlace> view_of(Key key) const;
  /// Steps back until the whole box is in the picture, unless it is already.
  void make_room_for(const Eigen::AlignedBox3d& box);

  /// Says how the user looks at the screen, where it is a window; nullopt: it is none.
  void see_by(const std::optional<WindowLook>& look) { look_ = look; }
  /// Looks from now on as that camera does, whatever mouse and keys do to the view; nullopt: as they have it.
  void look_as(const std::optional<DrawCamera>& camera);

  /// Tells whether the view goes to another place by itself.
  bool is_under_way() const { return orbit_.is_under_way(); }
  const ViewPlace& place() const { return leading_ ? leading_place_ : orbit_.place(); }
  /// Returns what the picture is seen by, which the pointer is in.
  DrawCamera camera() const;
  Ray pointer() const;
  const Eigen::Vector2d& pointer_pixel() const { return pointer_; }
  bool is_held(Key key) const { return keys_.is_held(key); }

 private:
  OrbitView orbit_;
  std::optional<WindowLook> look_;
  std::optional<DrawCamera> leading_;  // that the user looks by; nullopt: by the orbit
  ViewPlace leading_place_;
  double fov_ = 0.8;  // vertical, rad
  std::array<std::optional<ViewPlace>, saved_views> views_{};
  bool flies_ = false;  // turning moves the target about the eye, not the eye about the target
  HeldKeys keys_;
  int width_ = 1, height_ = 1;                         // of the picture, pixels
  Eigen::Vector2d pointer_ = Eigen::Vector2d::Zero();  // pixels from the top left
  bool drags_ = false;                                 // with the right button
  double drag_depth_ = 1;                              // m ahead of the eye: what was taken hold of

  DrawCamera resting_camera() const;
  void press(Key key, const DeskRoom& room);
  void drag(const Eigen::Vector2d& by);
  void turn(const Eigen::Vector2d& by);
  void fly(double seconds, const GamepadUser& pad);
};

}  // namespace prosector
