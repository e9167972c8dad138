#include "client/app/desk.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/clock.h"
#include "common/grasp.h"

namespace prosector {
namespace {

constexpr double reach_per_notch = 0.01;  // m
constexpr double wrist_per_notch = 0.1;   // rad
constexpr double pad_reach_speed = 0.4;   // m/s
constexpr double pad_wrist_speed = 1.5;   // rad/s
constexpr double first_reach = 0.7;       // of the way to what the view is of, where nothing is seen
constexpr double farthest_surface = 4;    // m: what is farther is out of a hand's reach
constexpr double double_click_pixels = 6;
constexpr std::chrono::milliseconds double_click{350};
constexpr std::chrono::milliseconds slide_interval{40};  // a server takes no more than 50 commands a second
constexpr std::chrono::seconds fresh_touch{3};  // a panel comes up so soon after the touch that opens it

constexpr Key section_key = key_of('X');

Shown next(Shown shown) {
  return static_cast<Shown>((static_cast<std::size_t>(shown) + 1) % value_scales.size());
}

CommandKind command_of(HandWish wish) {
  return wish == HandWish::grasp ? CommandKind::grasp : CommandKind::release;
}

/// Returns what finds surfaces of the room, which outlives it.
FindSurface finder(const DeskRoom& room) {
  return [&room](const Ray& ray, std::optional<BodyId> only) -> std::optional<Picked> {
    const auto met = room.surface(ray);
    return met && (!only || met->body == *only) ? met : std::nullopt;
  };
}

}  // namespace

void Desk::begin(const DeskStart& start, std::chrono::steady_clock::time_point now) {
  view_.begin(start, window_.width(), window_.height());
  hand_.begin(view_.pointer(), first_reach * start.home.distance);
  last_update_ = now;
}

void Desk::update(const DeskSession& session, std::chrono::steady_clock::time_point now) {
  const double seconds = last_update_ ? std::chrono::duration<double>(now - *last_update_).count() : 0;
  last_update_ = now;
  follow_touch(session, now);
  follow_panel(session, now);
  pace_ = session.pace;
  scale_ = session.scale;
  time_.see(session.watched, std::chrono::duration<double>(now.time_since_epoch()).count());
  for (const WindowEvent& event : window_.poll_events()) take(event, session);
  frame_parts(session.room);
  ask(panel_.take_placing());
  view_.advance(seconds, pad_);
  leave_panel();
  move_hand(session, seconds);
  parts_.lay_out(session.parts, pointed_, Eigen::Vector2d(window_.width(), window_.height()) / session.scale);
}

void Desk::wait() {
  for (const WindowEvent& event : window_.poll_events()) {
    const auto* key = std::get_if<KeyEvent>(&event);
    if (std::get_if<CloseRequested>(&event) || (key && key->down && key->key == Key::escape)) closed_ = true;
  }
}

/// Takes an event, unless it is for the list of parts.
void Desk::take(const WindowEvent& event, const DeskSession& session) {
  if (const auto* pad = std::get_if<GamepadMoved>(&event)) {
    for (const WindowEvent& same : pad_.take(pad->now)) take(same, session);
    for (int calls = pad_.take_list_calls(); calls > 0; --calls) parts_.open_or_shut_by_hand();
    const int notches = pad_.take_notches();
    if (notches != 0 && points_over_room()) take(WheelTurned{0, static_cast<double>(notches)}, session);
  }
  Eigen::Vector2d pointer = view_.pointer_pixel();
  if (const auto* mouse = std::get_if<MouseMoved>(&event)) pointer = {mouse->x, mouse->y};
  if (!parts_.take(event, pointer / session.scale)) act(event, session);
}

void Desk::act(const WindowEvent& event, const DeskSession& session) {
  const DeskRoom& room = session.room;
  view_.take(event, room);
  if (std::get_if<CloseRequested>(&event)) closed_ = true;
  if (const auto* key = std::get_if<KeyEvent>(&event); key != nullptr && key->down && !key->repeat)
    press(key->key);
  if (const auto* key = std::get_if<KeyEvent>(&event);
      key != nullptr && key->key == section_key && !key->repeat)
    press_for_section(key->down, room);
  if (const auto* button = std::get_if<MouseButtonEvent>(&event)) {
    if (button->button == MouseButton::left) button->down ? press_button(room) : let_go();
    trace_cut(session);
    if (button->button == MouseButton::middle && button->down) request_panel();
  }
  if (const auto* wheel = std::get_if<WheelTurned>(&event))
    turn_wheel(wheel->y != 0 ? wheel->y : wheel->x);  // some systems turn it sideways while Shift is held
  if (!std::get_if<MouseMoved>(&event)) return;
  ask(time_.move(frame(), pointer_point()));
  panel_.drag(view_.pointer());
  trace_cut(session);
  if (sliding_ && std::chrono::steady_clock::now() - last_slide_ > slide_interval)
    if (const auto point = panel_.at(view_.pointer())) slide(point->at);
}

void Desk::press(Key key) {
  if (key == Key::escape) closed_ = true;
  if (key == Key::tab) ++follow_requests_;
  if (key == Key::f1 || key == key_of('H')) choices_.help = !choices_.help;
  if (key == Key::f11) choices_.full_screen = !choices_.full_screen;
  if (key == Key::f12) picture_request_ = view_.is_held(Key::shift) ? 2 : 1;
  if (key == key_of('C')) choices_.wireframes = !choices_.wireframes;
  if (key == key_of('I')) choices_.figures = !choices_.figures;
  if (key == key_of('P')) request_panel();
  if (panel_.shown() && view_.view_of(key)) leaves_panel_ = true;
  if (key == key_of('V')) choices_.shown = next(choices_.shown);
  if (key == key_of('Z')) take_back();
  press_for_time(key);
}

/// Takes the last cut back, once a blade that draws one is out of the tissue: it would cut on its way.
void Desk::take_back() {
  hand_.lift_blade();
  takes_back_ = true;
}

/// Asks for what the host alone is granted: the server tells others so.
void Desk::press_for_time(Key key) {
  ask(time_.press(key));
  if (key == Key::space) ask(CommandKind::set_pace, PanelControl::attach, pace_ == 0 ? 1 : 0);
  if (key == key_of(',')) ask(CommandKind::set_pace, PanelControl::attach, std::max(pace_ / 2, least_pace));
  if (key == key_of('.')) {
    ask(CommandKind::step_ticks);
    commands_.back().revision = 1;
  }
}

void Desk::press_for_section(bool down, const DeskRoom& room) {
  const ViewPlace& place = view_.place();
  const auto point = down ? room.surface(view_.pointer()) : std::nullopt;
  const bool opens = point && (!room.opens || room.opens(point->body));
  down ? section_.press(place.back(), opens ? room.box(point->body).center() : place.target)
       : section_.let_go();
  choices_.section = section_.plane();
}

void Desk::turn_wheel(double notches) {
  if (view_.is_held(section_key)) {
    section_.move(notches);
    choices_.section = section_.plane();
    return;
  }
  if (view_.is_held(Key::control)) return;  // the view zooms
  if (at_panel() && !hand_.is_pressed())
    panel_.scroll(-notches);
  else if (view_.is_held(Key::shift))
    hand_.turn(wrist_per_notch * notches, 0);
  else if (view_.is_held(Key::alt))
    hand_.turn(0, wrist_per_notch * notches);
  else
    hand_.reach(reach_per_notch * notches);
}

void Desk::move_hand(const DeskSession& session, double seconds) {
  const PadStick wrist = pad_.wrist();
  if (!points_over_room()) hand_.reach(pad_reach_speed * seconds * pad_.reach());
  hand_.turn(pad_wrist_speed * seconds * wrist.right, -pad_wrist_speed * seconds * wrist.down);
  HandGuide guide;
  guide.pointer = view_.pointer();
  guide.back = view_.place().back();
  guide.yaw = view_.place().yaw;
  guide.pitch = view_.place().pitch;
  guide.still = points_over_room() && !hand_.is_pressed();  // which it would hide
  const auto point = session.room.surface(guide.pointer);
  pointed_ = point && !points_over_room() ? std::optional(point->body) : std::nullopt;
  if (point && point->distance < farthest_surface) {
    guide.surface = point->distance;
    guide.soft = session.is_soft(point->body);
    guide.level = point->normal.y();
  }
  guide.gap = [&](const Vec3& place) -> std::optional<double> {
    const Vec3 way = place - guide.pointer.from;
    const auto behind = session.room.surface({guide.pointer.from, way.normalized()});
    return behind ? std::optional(behind->distance - way.norm()) : std::nullopt;
  };
  guide.physical = session.physical_hand;
  guide.is_paused = session.pace == 0;
  guide.tip = session.tip;
  guide.blade = session.blade;
  guide.at_blade = point && session.is_blade && session.is_blade(point->body);
  guide.right = view_.place().pose().q * Vec3::UnitX();
  if (point && guide.soft && !at_panel()) guide.tissue = point;
  guide.find = finder(session.room);
  hand_.advance(guide, seconds);
  if (!hand_.draws() && std::exchange(takes_back_, false)) ask(CommandKind::undo);
  for (const HandWish wish : hand_.take_wishes()) {
    ask(command_of(wish));
    if (wish == HandWish::release || !pressed_at_) continue;
    commands_.back().body = *pressed_at_;
    commands_.back().revision = grasps_body;
  }
}

/// Keeps the pointer's way on tissue while a blade may be drawn along it: much of it lies between two
/// pictures.
void Desk::trace_cut(const DeskSession& session) {
  if (!hand_.is_pressed() || !hand_.cut_depth()) return;
  const auto point = session.room.surface(view_.pointer());
  if (point && session.is_soft(point->body) && !at_panel()) hand_.trace(*point, finder(session.room));
}

/// Takes the button: on the user's panel it works the controls, elsewhere it grasps. The second press of a
/// double click frames what is there; the first one is too short to grasp.
void Desk::press_button(const DeskRoom& room) {
  if (const auto wanted = time_.press(frame(), pointer_point())) return ask(wanted);
  if (const auto steps_down = panel_.effort_at(view_.pointer())) {
    ask(CommandKind::set_effort);
    commands_.back().body = panel_.shown()->body;
    commands_.back().revision = *steps_down;
  } else if (const auto accuracy = panel_.accuracy_at(view_.pointer())) {
    ask(CommandKind::set_accuracy);
    commands_.back().body = panel_.shown()->body;
    commands_.back().value = *accuracy;
  } else if (const auto point = panel_.at(view_.pointer())) {
    press_panel(*point);
  } else {
    pressed_at_ = pointed_;
    is_double_click() ? view_.frame_pointed(room) : hand_.press();
  }
}

/// Works what is there of the panel. Its head is dragged; a double click puts the panel back.
void Desk::press_panel(const PanelPoint& point) {
  if (is_panel_head(point)) {
    is_double_click() ? panel_.put_back() : panel_.take_hold(view_.pointer(), point, view_.place().back());
  } else if (point.control == PanelControl::stiffness) {
    sliding_ = true;
    slide(point.at);
  } else if (point.control) {
    const ControlState& button = panel_.shown()->controls[static_cast<std::size_t>(*point.control)];
    ask(CommandKind::set_control, *point.control, button.on ? 0 : 1);
  }
}

/// Tells whether this press is a double click's second one, and keeps it in mind as a first one if not.
bool Desk::is_double_click() {
  const auto now = std::chrono::steady_clock::now();
  const Eigen::Vector2d& pixel = view_.pointer_pixel();
  const bool second =
      now - last_press_ < double_click && (pixel - last_press_pixel_).norm() < double_click_pixels;
  last_press_ = second ? std::chrono::steady_clock::time_point() : now;
  last_press_pixel_ = pixel;
  return second;
}

void Desk::let_go() {
  sliding_ = false;
  ask(time_.let_go());
  panel_.let_go();
  if (hand_.is_pressed()) hand_.let_go();
}

void Desk::request_panel() {
  panel_request_ = view_.pointer();
}

/// Keeps what the physical hand touches, and since when.
void Desk::follow_touch(const DeskSession& session, std::chrono::steady_clock::time_point now) {
  if (touched_ != session.touched) touches_since_ = now;
  touched_ = session.touched;
}

/// Keeps the panel as it is now, and open while it is pointed at. One that the user asked for is brought into
/// the picture when it comes up. One that a hovering hand opened, because it grazed the part, is closed.
void Desk::follow_panel(const DeskSession& session, std::chrono::steady_clock::time_point now) {
  const bool is_new = panel_.follow(session.own_panel, session.effort, session.hidden_panel_lines);
  if (panel_.asks_to_stay(view_.pointer())) {
    ask(CommandKind::open_panel);
    commands_.back().body = panel_.shown()->body;
  }
  if (!is_new) return;
  if (!std::exchange(awaits_panel_, false)) {
    const bool grazed = touched_ == panel_.shown()->body && now - touches_since_ < fresh_touch;
    if (grazed && hand_.hovers()) ask(CommandKind::close_panel);
    return;
  }
  Eigen::AlignedBox3d box;
  for (const double x : {-panel_width / 2, panel_width / 2})
    for (const double y : {panel_.bottom(), panel_height / 2})
      box.extend(panel_.shown()->pose * Vec3(x, y, 0));
  view_.make_room_for(box);
}

/// Closes the panel once the view has come to another place. It faces the view in which it came up: seen from
/// elsewhere it hides its part. A hand that touches a part opens the panel again, facing the new view.
void Desk::leave_panel() {
  if (!leaves_panel_ || view_.is_under_way()) return;
  leaves_panel_ = false;
  if (panel_.shown()) ask(CommandKind::close_panel);
}

void Desk::frame_parts(const DeskRoom& room) {
  Eigen::AlignedBox3d box;
  for (const BodyId body : parts_.take_framed()) box.extend(room.box(body));
  view_.frame(box);
}

void Desk::slide(const Vec3& at) {
  last_slide_ = std::chrono::steady_clock::now();
  ask(CommandKind::set_control, PanelControl::stiffness, slider_position(at));
}

void Desk::ask(const std::optional<Command>& command) {
  if (command) commands_.push_back(*command);
}

void Desk::ask(CommandKind kind, PanelControl control, double value) {
  Command& command = commands_.emplace_back();
  command.kind = kind;
  command.control = control;
  command.value = value;
}

HandInput Desk::input() const {
  HandInput input;
  input.time_ns = monotonic_ns();
  input.head_tracked = true;
  input.head = eye();
  HandPose& hand = input.hands[right_hand];
  hand.tracked = !hand_.is_withdrawn();
  hand.pose = hand_.pose();
  hand.flexion.fill(hand_.flexion());
  hand.gesture = hand_.is_closed() ? Gesture::fist : Gesture::flat;
  if (hand_.is_drawing()) hand.buttons = draws_cut;
  return input;
}

std::vector<Command> Desk::take_commands() {
  return std::exchange(commands_, {});
}

std::size_t Desk::take_follow_requests() {
  return std::exchange(follow_requests_, 0);
}

std::optional<Ray> Desk::take_panel_request() {
  return std::exchange(panel_request_, std::nullopt);
}

}  // namespace prosector
