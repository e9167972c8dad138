#pragma once
// The desk user: mouse and keyboard move the view and drive a hand.

#include <chrono>
#include <optional>
#include <set>

#include "client/render/window_context.h"
#include "common/messages.h"

namespace prosector {

/// For people; told when a desk user joins.
inline constexpr const char* desk_help =
    "mouse: moves your hand    wheel: how far away it is    left button: grasps while held\n"
    "right drag: turns the view    W A S D Q E: fly    Esc: leave";

class Desk {
 public:
  explicit Desk(WindowContext& window) : window_(window) {}

  /// Takes the window's events and moves the view; `start` is where it begins.
  void update(const CameraInfo& start);
  bool closed() const { return closed_; }
  const Pose& eye() const { return eye_; }
  /// The user as mouse and keyboard have them.
  HandInput input() const;
  /// Grasp or release, when the button asked for it since the last call.
  std::optional<CommandKind> take_command();

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
  bool grasping_ = false, grasp_told_ = false;
  double flexion_ = 0.1;

  void begin(const CameraInfo& start);
  void take(const WindowEvent& event);
  void fly(double seconds);
  Pose hand_pose() const;
};

}  // namespace prosector
