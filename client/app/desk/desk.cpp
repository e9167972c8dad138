#include "client/app/desk/desk.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/clock.h"

namespace prosector {
namespace {

constexpr double reach_per_notch = 0.01;  // m
constexpr double wrist_per_notch = 0.1;   // rad
constexpr double pad_reach_speed = 0.4;   // m/s
constexpr double pad_wrist_speed = 1.5;   // rad/s
constexpr double first_reach =
    0.7;  // fraction of the distance to the view's target, before any surface is known
constexpr double farthest_surface = 4;  // m: surfaces farther away are out of the hand's reach
constexpr double double_click_pixels = 6;
constexpr std::chrono::milliseconds double_click{350};
constexpr std::chrono::milliseconds slide_interval{40};  // the server accepts at most 50 commands a second
constexpr std::chrono::seconds fresh_touch{
    3};  // a panel that opens within this time of a touch was opened by it

constexpr Key section_key = key_of('X');

Shown next(Shown shown) {
  return static_cast<Shown>((static_cast<std::size_t>(shown) + 1) % value_scales.size());
}

/// Returns a function that finds surfaces of the room. The room must outlive it.
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

/// Processes an event, unless the list of parts consumes it.
void Desk::take(const WindowEvent& event, const DeskSession& session) {
  if (const auto* pad = std::get_if<GamepadMoved>(&event)) {
    for (const WindowEvent& same : pad_.take(pad->now)) take(same, session);
    for (int calls = pad_.take_list_calls(); calls > 0; --calls) parts_.toggle_without_search();
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
    turn_wheel(wheel->y != 0 ? wheel->y : wheel->x);  // some systems scroll horizontally while Shift is held
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
  if (key == key_of('Z')) undo_last_cut();
  press_for_time(key);
}

/// Undoes the last cut after a blade that is drawing one has left the tissue, because it would cut on its way
/// out.
void Desk::undo_last_cut() {
  hand_.lift_blade();
  undo_pending_ = true;
}

/// Sends time commands, which only the host may use. The server replies to other users with a refusal.
void Desk::press_for_time(Key key) {
  ask(time_.press(key));
  if (key == Key::space) ask(SetPace{pace_ == 0 ? 1.0 : 0.0});
  if (key == key_of(',')) ask(SetPace{std::max(pace_ / 2, min_pace)});
  if (key == key_of('.')) ask(StepTicks{1});
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
  guide.still = points_over_room() && !hand_.is_pressed();  // the hand would cover the panel or the list
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
  if (!hand_.draws() && std::exchange(undo_pending_, false)) ask(Undo{});
  for (const HandRequest wish : hand_.take_wishes())
    ask(wish == HandRequest::grasp ? CommandBody(Grasp{right_hand, pressed_at_})
                                   : CommandBody(Release{right_hand}));
}

/// Records the pointer's path on tissue while a blade may be drawn along it: several events arrive between
/// two frames.
void Desk::trace_cut(const DeskSession& session) {
  if (!hand_.is_pressed() || !hand_.cut_depth()) return;
  const auto point = session.room.surface(view_.pointer());
  if (point && session.is_soft(point->body) && !at_panel()) hand_.trace(*point, finder(session.room));
}

/// Handles the button press: on the user's panel it operates the controls, elsewhere it grasps. The second
/// press of a double click frames the part; the first one is too short to grasp.
void Desk::press_button(const DeskRoom& room) {
  if (const auto wanted = time_.press(frame(), pointer_point())) return ask(wanted);
  if (const auto steps_down = panel_.effort_at(view_.pointer())) {
    ask(SetEffort{panel_.shown()->body, *steps_down});
  } else if (const auto accuracy = panel_.accuracy_at(view_.pointer())) {
    ask(SetAccuracy{panel_.shown()->body, *accuracy});
  } else if (const auto point = panel_.at(view_.pointer())) {
    press_panel(*point);
  } else {
    pressed_at_ = pointed_;
    is_double_click() ? view_.frame_pointed(room) : hand_.press();
  }
}

/// Operates the panel at this point. Its header is dragged; a double click returns the panel to its original
/// position.
void Desk::press_panel(const PanelPoint& point) {
  if (is_panel_head(point)) {
    is_double_click() ? panel_.put_back() : panel_.take_hold(view_.pointer(), point, view_.place().back());
  } else if (point.control == PanelControl::stiffness) {
    sliding_ = true;
    slide(point.at);
  } else if (point.control) {
    const ControlState& button = panel_.shown()->controls[static_cast<std::size_t>(*point.control)];
    ask(SetControl{*point.control, button.on ? 0.0 : 1.0});
  }
}

/// Reports whether this press is the second of a double click. If not, records it as a possible first.
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

/// Stores the body that the simulated hand touches and the time of the first contact.
void Desk::follow_touch(const DeskSession& session, std::chrono::steady_clock::time_point now) {
  if (touched_ != session.touched) touches_since_ = now;
  touched_ = session.touched;
}

/// Updates the panel and keeps it open while the pointer is on it. A requested panel is brought into the
/// frame when it opens. A panel that a hovering hand opened by grazing the part is closed.
void Desk::follow_panel(const DeskSession& session, std::chrono::steady_clock::time_point now) {
  const bool is_new = panel_.follow(session.own_panel, session.effort, session.hidden_panel_lines);
  if (panel_.should_keep_open(view_.pointer())) ask(OpenPanel{panel_.shown()->body});
  if (!is_new) return;
  if (!std::exchange(awaits_panel_, false)) {
    const bool grazed = touched_ == panel_.shown()->body && now - touches_since_ < fresh_touch;
    if (grazed && hand_.hovers()) ask(ClosePanel{});
    return;
  }
  Eigen::AlignedBox3d box;
  for (const double x : {-panel_width / 2, panel_width / 2})
    for (const double y : {panel_.bottom(), panel_height / 2})
      box.extend(panel_.shown()->pose * Vec3(x, y, 0));
  view_.make_room_for(box);
}

/// Closes the panel after the view has reached a new position. The panel faces the view in which it opened:
/// seen from elsewhere it hides its part. Touching a part opens it again, facing the new view.
void Desk::leave_panel() {
  if (!leaves_panel_ || view_.is_under_way()) return;
  leaves_panel_ = false;
  if (panel_.shown()) ask(ClosePanel{});
}

void Desk::frame_parts(const DeskRoom& room) {
  Eigen::AlignedBox3d box;
  for (const BodyId body : parts_.take_framed()) box.extend(room.box(body));
  view_.frame(box);
}

void Desk::slide(const Vec3& at) {
  last_slide_ = std::chrono::steady_clock::now();
  ask(SetControl{PanelControl::stiffness, slider_position(at)});
}

void Desk::ask(const std::optional<CommandBody>& command) {
  if (command) commands_.push_back(*command);
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

std::vector<CommandBody> Desk::take_commands() {
  return std::exchange(commands_, {});
}

std::size_t Desk::take_follow_requests() {
  return std::exchange(follow_requests_, 0);
}

std::optional<Ray> Desk::take_panel_request() {
  return std::exchange(panel_request_, std::nullopt);
}

}  // namespace prosector
