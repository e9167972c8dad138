#pragma once
// The desk user: mouse and keyboard, or a gamepad, move the view and drive a hand.

#include <chrono>
#include <optional>
#include <utility>
#include <vector>

#include "client/app/desk/desk_hand.h"
#include "client/app/desk/desk_panel.h"
#include "client/app/desk/desk_section.h"
#include "client/app/desk/desk_view.h"
#include "client/app/desk/gamepad_user.h"
#include "client/app/desk/parts_desk.h"
#include "client/app/desk/time_control.h"
#include "client/render/window_context.h"
#include "client/view/value_paint.h"
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

/// Display options that a desk user has chosen with keys: coloured quantity, section plane, wireframes,
/// statistics, help, and full screen.
struct DeskChoices {
  Shown shown = Shown::none;
  std::optional<SectionPlane> section = {};  // clipping plane
  bool wireframes = false, figures = false, help = false, full_screen = false;
};

class Desk {
 public:
  /// Creates the desk for a window with these initial display options. begin() must follow.
  Desk(WindowContext& window, const DeskChoices& choices) : window_(window), choices_(choices) {}

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
  Pose eye() const { return view_.place().pose(); }
  /// Sets the position of the user's eyes in front of a screen that acts as a window into the room; nullopt:
  /// the screen shows a normal view.
  void set_window_look(const std::optional<WindowLook>& look) { view_.set_window_look(look); }
  /// Returns the camera with which the frame is rendered.
  DrawCamera camera() const { return view_.camera(); }
  /// Makes the view follow this camera, for instance that of an augmented image; nullopt: mouse and keyboard
  /// control the view.
  void follow_camera(const std::optional<DrawCamera>& camera) { view_.follow_camera(camera); }
  /// Returns the target poses of head and hand that the user sets with mouse, keyboard or gamepad, to be sent
  /// to the server.
  HandInput input() const;
  /// Returns and removes the commands to the server that the user has requested since the last call, such as
  /// grasp, release, or setting a panel's control.
  std::vector<CommandBody> take_commands();
  /// Returns the ray (world frame) of the pointer at the user's last request for the panel of the part under
  /// it. Returns nullopt if there was no request since the last call.
  std::optional<Ray> take_panel_request();
  /// Notes that the server was asked to open a panel, so that the view makes room for it when it opens.
  void expect_panel() { awaits_panel_ = true; }
  bool has_gamepad() const { return pad_.is_there(); }
  const DeskChoices& choices() const { return choices_; }
  /// Returns the body under the pointer; nullopt if the pointer is on a panel, on the list of parts, or on no
  /// body.
  std::optional<BodyId> pointed() const { return pointed_; }
  PartsDesk& parts() { return parts_; }
  const PartsDesk& parts() const { return parts_; }
  /// Returns the pose to which the user drags their panel, if any, and the scroll position of its text.
  PanelLook panel_look() const { return panel_.look(); }
  /// Returns the position of the pointer, pixels from the frame's top left.
  const Eigen::Vector2d& pointer_pixel() const { return view_.pointer_pixel(); }
  /// Returns the line (points in m, world frame) that the blade in the hand will or would cut; empty without
  /// a blade on tissue. The function cut_depth() returns the cutting depth set for the blade, m; nullopt
  /// without a blade.
  const std::vector<Vec3>& cut_line() const { return hand_.cut_line(); }
  std::optional<double> cut_depth() const { return hand_.cut_depth(); }
  /// Returns the tick of a recording to which the user has requested to jump and that is not displayed yet;
  /// nullopt if there is none.
  std::optional<std::uint64_t> wished_tick() const { return time_.wish(); }
  /// Returns how often, since the last call, the user has pressed the key that shows the view of the next
  /// participant.
  std::size_t take_follow_requests();
  /// Returns the size of the screenshot that the user requested since the last call, as a multiple of the
  /// window's size: 1 or 2; 0 if none was requested.
  int take_picture_request() { return std::exchange(picture_request_, 0); }

 private:
  WindowContext& window_;
  bool closed_ = false;
  DeskView view_;
  DeskHand hand_;
  DeskSection section_;
  GamepadUser pad_;
  PartsDesk parts_;
  TimeControl time_;
  std::optional<std::chrono::steady_clock::time_point> last_update_;
  DeskChoices choices_;
  std::size_t follow_requests_ = 0;
  int picture_request_ = 0;

  // Pointer interaction with parts and panels.
  DeskPanel panel_;
  bool sliding_ = false;  // the left button drags the slider
  std::chrono::steady_clock::time_point last_slide_{}, last_press_{};
  Eigen::Vector2d last_press_pixel_ = Eigen::Vector2d::Zero();
  std::vector<CommandBody> commands_;
  std::optional<Ray> panel_request_;
  std::optional<BodyId> pointed_;
  std::optional<BodyId> pressed_at_;  // body under the pointer when the button was pressed
  double pace_ = 1, scale_ = 1;
  std::optional<BodyId> touched_;  // body that the simulated hand touches
  std::chrono::steady_clock::time_point touches_since_{};
  bool awaits_panel_ = false;  // a requested panel has not opened yet
  bool leaves_panel_ = false;  // the view is moving to a saved position
  bool undo_pending_ = false;  // an undo is pending until no cut drives the blade

  void take(const WindowEvent& event, const DeskSession& session);
  void act(const WindowEvent& event, const DeskSession& session);
  void press(Key key);
  void press_for_time(Key key);
  void undo_last_cut();
  void ask(const std::optional<CommandBody>& command);
  OverlayFrame frame() const { return {view_.camera(), scale_}; }
  Eigen::Vector2d pointer_point() const { return view_.pointer_pixel() / scale_; }
  void press_for_section(bool down, const DeskRoom& room);
  void turn_wheel(double notches);
  void press_button(const DeskRoom& room);
  void press_panel(const PanelPoint& point);
  bool is_double_click();
  void let_go();
  void trace_cut(const DeskSession& session);
  void request_panel();
  void follow_panel(const DeskSession& session, std::chrono::steady_clock::time_point now);
  void follow_touch(const DeskSession& session, std::chrono::steady_clock::time_point now);
  void leave_panel();
  void slide(const Vec3& at);
  void frame_parts(const DeskRoom& room);
  void move_hand(const DeskSession& session, double seconds);
  bool at_panel() const { return panel_.covers(view_.pointer()); }
  /// Returns whether the pointer operates a panel or the list of parts rather than the room.
  bool points_over_room() const { return at_panel() || parts_.has_pointer(); }
};

}  // namespace prosector
