#pragma once
// The desk user: mouse and keyboard move the view and drive a hand.

#include <chrono>
#include <optional>
#include <set>
#include <vector>

#include "client/render/window_context.h"
#include "client/view/pick.h"
#include "client/view/value_paint.h"
#include "common/messages.h"

namespace prosector {

/// For people; told when a desk user joins.
inline constexpr const char* desk_help =
    "mouse: moves your hand    wheel: how far away it is    left button: grasps while held\n"
    "right drag: turns the view    W A S D Q E: fly    C: collision models    V: strain, residual, error    "
    "Esc: leave\n"
    "P or middle button: the panel of the part under the pointer; left button: works its controls";

class Desk {
 public:
  /// `shown`: what soft bodies' colours tell at first.
  explicit Desk(WindowContext& window, Shown shown = Shown::none) : window_(window), shown_(shown) {}

  /// Takes the window's events and moves the view; `start` is where it begins, `own_panel` the user's open
  /// one, or null.
  void update(const CameraInfo& start, const Panel* own_panel);
  bool closed() const { return closed_; }
  const Pose& eye() const { return eye_; }
  /// The user as mouse and keyboard have them.
  HandInput input() const;
  /// What the mouse asked for since the last call: to grasp, to release, to set a control. Who asks is the
  /// caller's to fill in.
  std::vector<Command> take_commands();
  /// Where the user asked for a panel since the last call.
  std::optional<Ray> take_panel_request();
  bool wireframes() const { return wireframes_; }
  Shown shown() const { return shown_; }

 private:
  WindowContext& window_;
  bool closed_ = false;

  // The view: an eye that looks at a target.
  std::optional<CameraInfo> view_;
  Pose eye_;
  double yaw_ = 0, pitch_ = 0, distance_ = 1;  // rad, rad, m: the eye about the target
  bool turning_ = false;
  std::set<Key> held_keys_;
  std::chrono::steady_clock::time_point last_update_{};

  // The hand: fingertips on the ray through the pointer.
  double pointer_x_ = 0, pointer_y_ = 0;  // pixels
  double reach_ = 0;                      // m from the eye to the fingertips
  bool grasping_ = false;
  double flexion_ = 0.1;
  Pose hand_;  // stays where it was while the pointer is at the panel, which it would hide

  // What the pointer does to parts and panels.
  std::optional<Panel> panel_;
  bool sliding_ = false;  // the left button holds the slider
  std::chrono::steady_clock::time_point last_slide_{};
  std::vector<Command> commands_;
  std::optional<Ray> panel_request_;
  bool wireframes_ = false;
  Shown shown_;

  void begin(const CameraInfo& start);
  void take(const WindowEvent& event);
  void fly(double seconds);
  void press();
  void let_go();
  void slide(const Vec3& at);
  void ask(CommandKind kind, PanelControl control = PanelControl::attach, double value = 0);
  DrawCamera camera() const;
  Ray pointer() const { return ray_through(camera(), pointer_x_, pointer_y_); }
  Pose hand_pose() const;
  bool at_panel() const { return panel_ && meet(pointer(), *panel_); }
};

}  // namespace prosector
