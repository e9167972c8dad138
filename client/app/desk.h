#pragma once
// The desk user: mouse and keyboard, or a gamepad, move the view and drive a hand.

#include <chrono>
#include <optional>
#include <set>
#include <vector>

#include "client/app/desk_hand.h"
#include "client/app/gamepad_user.h"
#include "client/render/window_context.h"
#include "client/view/pick.h"
#include "client/view/value_paint.h"
#include "common/messages.h"

namespace prosector {

/// Help for people; told when a desk user joins, and shown on a key.
inline constexpr const char* desk_help =
    "mouse: moves your hand    wheel: how far away it is    left button: grasps while held\n"
    "Shift and wheel: rolls the wrist    Ctrl and wheel: bends it\n"
    "P or middle button: the panel of the part under the pointer; left button: works its controls\n"
    "right drag: turns the view    W A S D Q E: move it    F: turn about the eye, or about what is seen\n"
    "Tab: through the eyes of the next user    F11: full screen\n"
    "C: collision models    V: strain, residual, error    I: figures    Z: takes back your last cut\n"
    "H or F1: these lines    Esc: leave\n"
    "gamepad: left stick and bumpers move the view, the right stick turns it, or the pointer with the\n"
    "left trigger pulled; cross: how far away the hand is; with the left trigger bumpers and cross turn the\n"
    "wrist    right trigger or lower button: left button\n"
    "left: panel    right: undo    upper: the next user's eyes    start: these lines";

class Desk {
 public:
  /// Takes what is shown at first, and whether it fills the screen.
  Desk(WindowContext& window, Shown shown, bool full_screen)
      : window_(window), shown_(shown), full_screen_(full_screen) {}

  /// Takes the window's events and moves the view; `start` is where it begins, `own_panel` the user's open
  /// one, or null.
  void update(const CameraInfo& start, const Panel* own_panel);
  /// Takes the window's events while there is nothing to see yet: closing counts, the rest does not.
  void wait();
  bool closed() const { return closed_; }
  const Pose& eye() const { return eye_; }
  /// Returns the user as mouse and keyboard have them.
  HandInput input() const;
  /// Returns what the mouse asked for since the last call: to grasp, to release, to set a control. Who asks
  /// is the caller's to fill in.
  std::vector<Command> take_commands();
  /// Returns where the user asked for a panel since the last call.
  std::optional<Ray> take_panel_request();
  bool wireframes() const { return wireframes_; }
  Shown shown() const { return shown_; }
  bool figures() const { return figures_; }
  bool help() const { return help_; }
  bool full_screen() const { return full_screen_; }
  /// Returns how often the user asked for the eyes of the next one since the last call.
  std::size_t take_follow_requests();

 private:
  WindowContext& window_;
  bool closed_ = false;

  // The view: an eye that looks at a target.
  std::optional<CameraInfo> view_;
  Pose eye_;
  double yaw_ = 0, pitch_ = 0, distance_ = 1;  // rad, rad, m: the eye about the target
  bool turning_ = false;
  bool flying_ = false;  // turning moves the target about the eye, not the eye about the target
  std::set<Key> held_keys_;
  std::set<Key> pressed_keys_;  // since the last update, whether or not they are still held
  GamepadUser pad_;
  std::chrono::steady_clock::time_point last_update_{};

  double pointer_x_ = 0, pointer_y_ = 0;  // pixels
  DeskHand hand_;
  Pose hand_pose_;  // stays where it was while the pointer is at the panel, which it would hide

  // What the pointer does to parts and panels.
  std::optional<Panel> panel_;
  bool sliding_ = false;  // the left button holds the slider
  std::chrono::steady_clock::time_point last_slide_{};
  std::vector<Command> commands_;
  std::optional<Ray> panel_request_;
  bool wireframes_ = false;
  Shown shown_;
  bool figures_ = false, help_ = false, full_screen_ = false;
  std::size_t follow_requests_ = 0;

  void begin(const CameraInfo& start);
  void take(const WindowEvent& event);
  void press(Key key);
  void turn(double right, double down);
  void fly(double seconds);
  void follow_pad(double seconds);
  Vec3 back() const;
  void turn_wheel(double notches);
  void press();
  void let_go();
  void slide(const Vec3& at);
  void ask(CommandKind kind, PanelControl control = PanelControl::attach, double value = 0);
  DrawCamera camera() const;
  Ray pointer() const { return ray_through(camera(), pointer_x_, pointer_y_); }
  bool at_panel() const { return panel_ && meet(pointer(), *panel_); }
};

}  // namespace prosector
