#pragma once
// The desk user: mouse and keyboard, or a gamepad, move the view and drive a hand.

#include <chrono>
#include <optional>
#include <utility>
#include <vector>

#include "client/app/desk_hand.h"
#include "client/app/desk_panel.h"
#include "client/app/desk_section.h"
#include "client/app/desk_view.h"
#include "client/app/gamepad_user.h"
#include "client/app/parts_desk.h"
#include "client/app/time_control.h"
#include "client/render/window_context.h"
#include "client/view/value_paint.h"
#include "common/messages.h"

namespace prosector {

/// What the desk knows of the session, each picture.
struct DeskSession {
  DeskRoom room;
  std::optional<Panel> own_panel = {};     // the user's open one
  std::optional<ShownEffort> effort = {};  // what strips below it say of how exactly its part is solved
  std::size_t hidden_panel_lines = 0;      // of its description, which do not fit on it
  std::optional<Pose> physical_hand = {};  // the wrist as physics has it
  std::optional<BodyId> touched = {};      // by the physical hand
  std::optional<Vec3> tip = {};            // of the instrument in the hand, wrist frame
  std::optional<BladeFrame> blade = {};    // in the hand, wrist frame
  std::function<bool(BodyId)> is_soft = {};
  std::function<bool(BodyId)> is_blade = {};  // empty: nothing is
  double pace = 1;                            // of simulated time; 0: it stands still
  std::vector<PartRow> parts = {};            // that the open list finds
  std::optional<ShownTime> watched = {};      // of the recording that is watched
  double scale = 1;                           // pixels of a point, in which overlays are measured
};

/// What a desk user chose to see.
struct DeskChoices {
  Shown shown = Shown::none;
  std::optional<SectionPlane> section = {};  // that opens bodies
  bool wireframes = false, figures = false, help = false, full_screen = false;
};

class Desk {
 public:
  /// Takes what is shown at first.
  Desk(WindowContext& window, const DeskChoices& choices) : window_(window), choices_(choices) {}

  /// Tells whether the user has a place to look from.
  bool has_begun() const { return last_update_.has_value(); }
  void begin(const DeskStart& start,
             std::chrono::steady_clock::time_point now = std::chrono::steady_clock::now());
  /// Takes the window's events and goes on by a picture, which is drawn at `now`.
  void update(const DeskSession& session,
              std::chrono::steady_clock::time_point now = std::chrono::steady_clock::now());
  /// Takes the window's events while there is nothing to see yet: closing counts, the rest does not.
  void wait();
  bool closed() const { return closed_; }
  Pose eye() const { return view_.place().pose(); }
  /// Says how the user looks at the screen, where it is a window; nullopt: it is none.
  void see_by(const std::optional<WindowLook>& look) { view_.see_by(look); }
  /// Returns what the picture is seen by.
  DrawCamera camera() const { return view_.camera(); }
  /// Looks from now on as a camera does that leads; nullopt: as mouse and keyboard have it.
  void look_as(const std::optional<DrawCamera>& camera) { view_.look_as(camera); }
  /// Returns the user as mouse and keyboard have them.
  HandInput input() const;
  /// Returns what the mouse asked for since the last call: to grasp, to release, to set a control. Who asks
  /// is the caller's to fill in.
  std::vector<Command> take_commands();
  /// Returns where the user asked for a panel since the last call.
  std::optional<Ray> take_panel_request();
  /// Takes that the server was asked to open a panel.
  void expect_panel() { awaits_panel_ = true; }
  bool has_gamepad() const { return pad_.is_there(); }
  const DeskChoices& choices() const { return choices_; }
  /// Returns the body that the pointer is at; nullopt: none, or a panel.
  std::optional<BodyId> pointed() const { return pointed_; }
  PartsDesk& parts() { return parts_; }
  const PartsDesk& parts() const { return parts_; }
  /// Returns what the user did to their panel.
  PanelLook panel_look() const { return panel_.look(); }
  /// Returns where the pointer is, pixels from the top left.
  const Eigen::Vector2d& pointer_pixel() const { return view_.pointer_pixel(); }
  /// Returns the line (m, world frame) and the depth (m) that the blade in the hand would cut.
  const std::vector<Vec3>& cut_line() const { return hand_.cut_line(); }
  std::optional<double> cut_depth() const { return hand_.cut_depth(); }
  /// Returns the tick of a recording that the user wants and that is not shown yet.
  std::optional<std::uint64_t> wished_tick() const { return time_.wish(); }
  /// Returns how often the user asked for the eyes of the next one since the last call.
  std::size_t take_follow_requests();
  /// Returns how many times as large as the window the user wants a picture kept, asked for since the last
  /// call: 1 or 2; 0: none.
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

  // What the pointer does to parts and panels.
  DeskPanel panel_;
  bool sliding_ = false;  // the left button holds the slider
  std::chrono::steady_clock::time_point last_slide_{}, last_press_{};
  Eigen::Vector2d last_press_pixel_ = Eigen::Vector2d::Zero();
  std::vector<Command> commands_;
  std::optional<Ray> panel_request_;
  std::optional<BodyId> pointed_;
  std::optional<BodyId> pressed_at_;  // what the pointer was at when the button went down
  double pace_ = 1, scale_ = 1;
  std::optional<BodyId> touched_;  // by the physical hand
  std::chrono::steady_clock::time_point touches_since_{};
  bool awaits_panel_ = false;  // asked for one that has not come up yet
  bool leaves_panel_ = false;  // the view goes to another place
  bool takes_back_ = false;    // the last cut, as soon as no blade is led

  void take(const WindowEvent& event, const DeskSession& session);
  void act(const WindowEvent& event, const DeskSession& session);
  void press(Key key);
  void press_for_time(Key key);
  void take_back();
  void ask(const std::optional<Command>& command);
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
  void ask(CommandKind kind, PanelControl control = PanelControl::attach, double value = 0);
  bool at_panel() const { return panel_.covers(view_.pointer()); }
  /// Tells whether the pointer is at the panel or the list of parts rather than at what lies in the room.
  bool points_over_room() const { return at_panel() || parts_.has_pointer(); }
};

}  // namespace prosector
