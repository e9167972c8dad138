#pragma once
// The desk user: mouse and keyboard, or a gamepad, move the view and drive a hand.

#include <chrono>
#include <functional>
#include <optional>
#include <vector>

#include "client/app/desk/desk_hand.h"
#include "client/app/desk/desk_panel.h"
#include "client/app/desk/desk_view.h"
#include "client/app/desk/display_keys.h"
#include "client/app/desk/double_click.h"
#include "client/app/desk/gamepad_user.h"
#include "client/app/desk/panel_mouse.h"
#include "client/app/desk/panel_opening.h"
#include "client/app/desk/parts_desk.h"
#include "client/app/desk/time_control.h"
#include "client/render/window_context.h"
#include "common/commands.h"
#include "common/hand_messages.h"
#include "common/ids.h"
#include "common/math.h"
#include "common/part_messages.h"

namespace prosector {

/// Session state that the desk (control of view and hand by mouse, keyboard or gamepad) needs in each frame.
struct DeskSession {
  DeskRoom room;
  std::optional<Panel> own_panel = {};  // the panel that the user has open
  std::optional<ShownEffort> effort =
      {};                              // solver effort of the panel's part, for the strips below the panel
  std::size_t hidden_panel_lines = 0;  // lines of the panel's description that do not fit on it
  std::optional<Pose> physical_hand = {};  // pose of the simulated wrist
  std::optional<BodyId> touched = {};      // body that the simulated hand touches
  std::optional<Vec3> tip = {};            // tip of the instrument in the hand, wrist frame, m
  std::optional<BladeFrame> blade = {};    // blade in the hand, wrist frame
  std::function<bool(BodyId)> is_soft = {};
  std::function<bool(BodyId)> is_blade = {};  // empty: no body is a blade
  double pace = 1;                            // ratio of simulated to real time; 0: paused
  std::vector<PartRow> parts = {};            // rows that the search in the open list finds
  std::optional<ShownTime> watched = {};      // displayed time of a recording; nullopt: the session is live
  double scale = 1;                           // pixels per point, the unit of overlays
};

class Desk {
 public:
  /// Creates the desk for a window with these initial display options. begin() must follow.
  Desk(WindowContext& window, const DeskChoices& choices) : window_(window), display_(choices) {}

  /// Returns whether begin() has set the user's initial view.
  bool has_begun() const { return last_update_.has_value(); }
  void begin(const DeskStart& start,
             std::chrono::steady_clock::time_point now = std::chrono::steady_clock::now());
  /// Processes the window's input events, and advances view and hand to `now`, the time at which the frame is
  /// drawn.
  void update(const DeskSession& session,
              std::chrono::steady_clock::time_point now = std::chrono::steady_clock::now());
  /// Processes the window's input events while there is no session to display. Only requests to close the
  /// window have an effect.
  void wait();
  bool closed() const { return closed_; }
  DeskView& view() { return view_; }
  const DeskView& view() const { return view_; }
  const DeskHand& hand() const { return hand_; }
  const DeskPanel& panel() const { return panel_; }
  const TimeControl& time() const { return time_; }
  DisplayKeys& display() { return display_; }
  const DisplayKeys& display() const { return display_; }
  PanelOpening& panel_opening() { return panel_opening_; }
  /// Returns the target poses of head and hand that the user sets with mouse, keyboard or gamepad, to be sent
  /// to the server.
  HandInput input() const;
  /// Returns and removes the commands to the server that the user has requested since the last call, such as
  /// grasp, release, or setting a panel's control.
  std::vector<CommandBody> take_commands();
  bool has_gamepad() const { return pad_.is_there(); }
  /// Returns the body under the pointer; nullopt if the pointer is on a panel, on the list of parts, or on no
  /// body.
  std::optional<BodyId> pointed() const { return pointed_; }
  PartsDesk& parts() { return parts_; }
  const PartsDesk& parts() const { return parts_; }

 private:
  WindowContext& window_;
  bool closed_ = false;
  DeskView view_;
  DeskHand hand_;
  GamepadUser pad_;
  PartsDesk parts_;
  TimeControl time_;
  DisplayKeys display_;
  DeskPanel panel_;
  PanelMouse panel_mouse_;
  PanelOpening panel_opening_;
  DoubleClick clicks_;
  std::optional<std::chrono::steady_clock::time_point> last_update_;
  std::vector<CommandBody> commands_;
  std::optional<BodyId> pointed_;
  std::optional<BodyId> pressed_at_;  // body under the pointer when the button was pressed
  double pace_ = 1, scale_ = 1;
  bool undo_pending_ = false;  // an undo is pending until no cut drives the blade

  void take(const WindowEvent& event, const DeskSession& session);
  void act(const WindowEvent& event, const DeskSession& session);
  void press(Key key);
  void ask(const std::optional<CommandBody>& command);
  void turn_wheel(double notches);
  void press_button(const DeskRoom& room);
  void let_go();
  void trace_cut(const DeskSession& session);
  void move_hand(const DeskSession& session, double seconds);
  /// Returns whether the pointer operates a panel or the list of parts rather than the room.
  bool points_over_room() const { return panel_.covers(view_.pointer()) || parts_.has_pointer(); }
};

}  // namespace prosector
